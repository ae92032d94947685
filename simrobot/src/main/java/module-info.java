/**
 * SimRobot: worlds, the Pioneer, the simulation, and on top of them the GSM modem (M2) and VeriCommand. Processes of robots
 * are written against {@link simrobot.behaviour}.
 */
open module simrobot {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.desktop;
    requires simgsm.web;
    requires vericommand;
    requires java.compiler;
    requires java.management;

    exports simrobot.behaviour;

    uses simrobot.behaviour.Behaviour;
}
