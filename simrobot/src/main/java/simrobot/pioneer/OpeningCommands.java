package simrobot.pioneer;

import java.util.function.BiConsumer;
import simrobot.p2os.P2osCommandNumber;
import simrobot.robot.Pioneer2Dx;

/** The initial settings of a session: limits above those of the commanded speeds, so that the wheels follow them. */
final class OpeningCommands {
    private static final int BOTH_BUMPERS_STALL = 3;

    /** The robot's limits of acceleration, as multiples of those of the commanded speeds. */
    private static final double RESERVE = 1.5;

    private OpeningCommands() {}

    /** @param robot receives each command with its argument */
    static void tell(BiConsumer<Integer, Integer> robot) {
        int acceleration = (int) Math.round(Pioneer2Dx.ACCELERATION_METERS_PER_SECOND2 * 1000 * RESERVE);
        int turnAcceleration =
                (int) Math.round(Math.toDegrees(Pioneer2Dx.TURN_ACCELERATION_RADIANS_PER_SECOND2) * RESERVE);
        robot.accept(P2osCommandNumber.SETV, (int) Math.round(Pioneer2Dx.TOP_SPEED_METERS_PER_SECOND * 1000));
        robot.accept(P2osCommandNumber.SETRV, (int) Math.round(Math.toDegrees(Pioneer2Dx.TOP_TURN_RADIANS_PER_SECOND)));
        robot.accept(P2osCommandNumber.SETA, acceleration);
        robot.accept(P2osCommandNumber.SETA, -acceleration);
        robot.accept(P2osCommandNumber.SETRA, turnAcceleration);
        robot.accept(P2osCommandNumber.SETRA, -turnAcceleration);
        robot.accept(P2osCommandNumber.BUMPSTALL, BOTH_BUMPERS_STALL);
        robot.accept(P2osCommandNumber.SONAR, 1);
    }
}
