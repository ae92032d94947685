package simrobot.app.ports;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import simgsm.web.AccessKeys;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.ros.RosSource;
import simrobot.simulation.SimulationThread;
import vericommand.OrderReport;
import vericommand.Reply;

/** The program's robots as ROS programs see them. */
record RosRobots(SimRobot simRobot, Optional<AccessKeys> keys) implements RosSource {
    @Override
    public List<String> robots() {
        return simRobot.robots().stream().map(TelephoneRobot::name).toList();
    }

    @Override
    public SimulationThread simulation() {
        return simRobot.simulation();
    }

    @Override
    public void order(String name, String operator, String keys, BiConsumer<Integer, String> ended) {
        simRobot.simulation()
                .post(() -> simRobot.robot(name)
                        .ifPresentOrElse(
                                robot -> robot.order(operator, keys, report -> {
                                    if (report.state() == OrderReport.State.ENDED) {
                                        ended.accept(
                                                report.reply()
                                                        .map(reply ->
                                                                reply.tone().number())
                                                        .orElse(0),
                                                report.reply().map(Reply::text).orElse(""));
                                    }
                                }),
                                () -> ended.accept(0, "no robot " + name + " any more")));
    }
}
