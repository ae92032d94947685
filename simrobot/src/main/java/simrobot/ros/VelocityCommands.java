package simrobot.ros;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import simrobot.robot.DirectControl;
import simrobot.robot.SimulatedRobot;

/**
 * The velocities commanded by ROS clients. A robot brakes 0.5 s after the last one, and when its client disconnects.
 * Owned by the simulation's thread; times are those of {@link System#nanoTime}, because the limit guards the
 * connection.
 */
final class VelocityCommands {
    static final long WATCHDOG_NANOS = 500_000_000;

    private record Driving(Object client, DirectControl control, long sinceNanos) {}

    private final Map<SimulatedRobot, Driving> driven = new HashMap<>();

    /** @return the reason why the velocity is refused; empty if the robot accepts it */
    Optional<String> drive(SimulatedRobot robot, Object client, Twist velocity, long nanos) {
        Driving before = driven.get(robot);
        DirectControl control = before == null ? new DirectControl(robot) : before.control;
        if (!control.take()) {
            String reason = robot.isUnderOrder() ? "executes an order" : "has no power or motors";
            return Optional.of("robot " + robot.name() + " " + reason + ", its velocity cannot be set");
        }
        if (before == null) {
            control.begin();
        }
        robot.drive().setSpeed(velocity.metersPerSecond());
        robot.drive().setTurnSpeed(velocity.radiansPerSecond());
        driven.put(robot, new Driving(client, control, nanos));
        return Optional.empty();
    }

    /** Brakes the robots driven by the client. */
    void release(Object client) {
        end(driving -> driving.client == client);
    }

    /** Brakes the robot if the client drives it. */
    void release(Object client, SimulatedRobot robot) {
        end(driving -> driving.client == client && driving == driven.get(robot));
    }

    /** Called after each step of the simulation. */
    void tick(long nanos) {
        if (!driven.isEmpty()) {
            end(driving -> nanos - driving.sinceNanos >= WATCHDOG_NANOS);
        }
    }

    private void end(Predicate<Driving> which) {
        driven.values().removeIf(driving -> {
            boolean ends = which.test(driving);
            if (ends) {
                driving.control.end();
            }
            return ends;
        });
    }
}
