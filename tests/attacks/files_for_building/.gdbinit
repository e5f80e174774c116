shell touch /tmp/meshgrade-attack-gdb
