// Reads the data that the page came with and shows it.

import { el, replace } from './dom';
import { Connection } from './live/connection';
import { LivePage } from './live/live_page';
import { CurvePage } from './live/curve_page';
import { PatchPage } from './live/patch_page';
import { showPicture } from './live/picture_page';
import type { LiveStart, PageData } from './model/types';
import { showClass } from './panels/class_page';
import { showReport } from './panels/report_page';

function readData(): PageData {
  const text = document.getElementById('meshgrade-data')?.textContent ?? '';
  return JSON.parse(text) as PageData;
}

function startLive(connection: Connection, start: LiveStart): void {
  if (start?.kind === 'curve') new CurvePage(app, connection, start.name, start.points);
  else if (start?.kind === 'patch') new PatchPage(app, connection, start.name, start.nets);
  else new LivePage(app, connection);
}

const app = document.getElementById('app')!;
const data = readData();
if (data.kind === 'report') {
  showReport(app, data.report);
} else if (data.kind === 'class') {
  showClass(app, data);
} else if (data.kind === 'picture') {
  showPicture(app, data);
} else if (data.kind === 'live') {
  startLive(new Connection(data.token), data.start);
} else {
  replace(app, el('main', { class: 'report' }, el('h1', {}, 'Meshgrade'),
    el('p', {}, 'This page has nothing to show: write a report with meshgrade check --html FILE.')));
}
