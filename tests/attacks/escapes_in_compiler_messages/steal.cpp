#error [2J]0;title ‮ evil <script>
int ‮ = 1;
