/** SimRobot: worlds, the Pioneer, the simulation, and on top of them the GSM modem (M2) and VeriCommand. */
module simrobot {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.desktop;
    requires vericommand;
    requires jdk.httpserver;
}
