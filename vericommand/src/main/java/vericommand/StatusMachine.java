package vericommand;

import static vericommand.RobotStatus.COLLISION;
import static vericommand.RobotStatus.DISCONNECTED;
import static vericommand.RobotStatus.MOVING;
import static vericommand.RobotStatus.NO_MOTORS;
import static vericommand.RobotStatus.STOPPED;

import java.util.List;
import java.util.Optional;

/** The robot's status and the one table of its transitions; whatever a row does not list is refused. */
public final class StatusMachine {
    /** One row of the table. */
    public record Transition(RobotStatus from, StatusEvent event, RobotStatus to) {}

    /** Off twice changes nothing, so that a switch may be thrown without asking first. */
    private static final List<Transition> TABLE = List.of(
            new Transition(DISCONNECTED, StatusEvent.POWER_ON, NO_MOTORS),
            new Transition(DISCONNECTED, StatusEvent.MOTORS_OFF, DISCONNECTED),
            new Transition(DISCONNECTED, StatusEvent.POWER_OFF, DISCONNECTED),
            new Transition(NO_MOTORS, StatusEvent.MOTORS_ON, STOPPED),
            new Transition(NO_MOTORS, StatusEvent.MOTORS_OFF, NO_MOTORS),
            new Transition(NO_MOTORS, StatusEvent.POWER_OFF, DISCONNECTED),
            new Transition(STOPPED, StatusEvent.MOTION_STARTED, MOVING),
            new Transition(STOPPED, StatusEvent.MOTORS_OFF, NO_MOTORS),
            new Transition(STOPPED, StatusEvent.POWER_OFF, DISCONNECTED),
            new Transition(MOVING, StatusEvent.MOTION_ENDED, STOPPED),
            new Transition(MOVING, StatusEvent.TOUCHED, COLLISION),
            new Transition(MOVING, StatusEvent.TURN_ENDED_BLOCKED, COLLISION),
            new Transition(MOVING, StatusEvent.MOTORS_OFF, NO_MOTORS),
            new Transition(MOVING, StatusEvent.POWER_OFF, DISCONNECTED),
            new Transition(COLLISION, StatusEvent.MOTION_STARTED, MOVING),
            new Transition(COLLISION, StatusEvent.MOTORS_OFF, NO_MOTORS),
            new Transition(COLLISION, StatusEvent.POWER_OFF, DISCONNECTED));

    private RobotStatus status;

    public StatusMachine(RobotStatus start) {
        status = start;
    }

    /** Every transition there is, in the order in which a diagram reads well. */
    public static List<Transition> table() {
        return TABLE;
    }

    /** Where the event leads from there; empty when the table does not list it. */
    public static Optional<RobotStatus> next(RobotStatus from, StatusEvent event) {
        return TABLE.stream()
                .filter(row -> row.from() == from && row.event() == event)
                .map(Transition::to)
                .findFirst();
    }

    public RobotStatus status() {
        return status;
    }

    public boolean accepts(StatusEvent event) {
        return next(status, event).isPresent();
    }

    /**
     * Makes the transition.
     *
     * @return the new status
     * @throws IllegalStateException when the present status does not list the event; the status stays as it was
     */
    public RobotStatus apply(StatusEvent event) {
        status = next(status, event)
                .orElseThrow(() ->
                        new IllegalStateException("\"" + event.text() + "\" is not possible in " + status.text()));
        return status;
    }

    /** The table as a PlantUML state diagram; what leaves the status as it is is not drawn. */
    public static String plantUml() {
        StringBuilder uml = new StringBuilder("@startuml status\ntitle The robot's status\nhide empty description\n");
        for (RobotStatus status : RobotStatus.values()) {
            uml.append("state \"%s\" as %s\n".formatted(status.text(), status.name()));
        }
        uml.append("[*] --> DISCONNECTED\n");
        TABLE.stream()
                .filter(row -> row.from() != row.to())
                .map(row -> "%s --> %s : %s\n"
                        .formatted(row.from(), row.to(), row.event().text()))
                .forEach(uml::append);
        return uml.append("@enduml\n").toString();
    }
}
