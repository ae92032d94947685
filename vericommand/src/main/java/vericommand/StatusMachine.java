package vericommand;

import static vericommand.RobotStatus.*;
import static vericommand.StatusEvent.*;

import java.util.EnumSet;
import simgsm.state.StateMachine;
import simgsm.state.StateTable;
import simgsm.state.StateTable.NoAction;

/** The robot's status; every transition without a row in the table is refused. */
public final class StatusMachine {
    /** Switching off is idempotent. */
    public static final StateTable<RobotStatus, StatusEvent, NoAction> TABLE = new StateTable<
                    RobotStatus, StatusEvent, NoAction>("robot status", DISCONNECTED)
            .on(DISCONNECTED, POWER_ON, NO_MOTORS)
            .on(NO_MOTORS, MOTORS_ON, STOPPED)
            .on(EnumSet.of(STOPPED, COLLISION), MOTION_STARTED, MOVING)
            .on(MOVING, MOTION_ENDED, STOPPED)
            .on(MOVING, TOUCHED, COLLISION)
            .on(MOVING, TURN_ENDED_BLOCKED, COLLISION)
            .on(EnumSet.complementOf(EnumSet.of(DISCONNECTED)), MOTORS_OFF, NO_MOTORS)
            .on(DISCONNECTED, MOTORS_OFF, DISCONNECTED)
            .on(EnumSet.allOf(RobotStatus.class), POWER_OFF, DISCONNECTED)
            .texts(RobotStatus::text, StatusEvent::text);

    private final StateMachine<RobotStatus, StatusEvent, NoAction> machine;

    public StatusMachine(RobotStatus start) {
        machine = new StateMachine<>(TABLE, "robot", action -> {}, start);
    }

    public RobotStatus status() {
        return machine.state();
    }

    public boolean accepts(StatusEvent event) {
        return machine.accepts(event);
    }

    /**
     * Makes the transition.
     *
     * @return the new status
     * @throws IllegalStateException when the table has no row for the event in the current status, which is kept
     */
    public RobotStatus apply(StatusEvent event) {
        if (!machine.fire(event)) {
            throw new IllegalStateException("\"" + event.text() + "\" is not possible in " + status().text());
        }
        return status();
    }
}
