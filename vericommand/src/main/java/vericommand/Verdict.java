package vericommand;

import java.util.SortedMap;

/** The result of verifying an order, before anything moves. */
public sealed interface Verdict {
    /** {@code accepted}, {@code refused} or {@code invalid}, for consoles and logs. */
    String word();

    /** The keys as received, without blanks; a valid order's without further stars of its opening. */
    String keys();

    record Accepted(Order order) implements Verdict {
        @Override
        public String word() {
            return "accepted";
        }

        @Override
        public String keys() {
            return order.keys();
        }
    }

    /**
     * A valid order that the robot's status does not permit.
     *
     * @param status the robot's at verification
     * @param tone 8 not possible, 6 executing another, 2 robot off
     */
    record Refused(Order order, RobotStatus status, ReplyTone tone) implements Verdict {
        @Override
        public String word() {
            return "refused";
        }

        @Override
        public String keys() {
            return order.keys();
        }
    }

    /**
     * A valid order for a process that the robot lacks.
     *
     * @param processes names of the robot's processes, by number
     */
    record NoProcess(Order order, SortedMap<Integer, String> processes) implements Verdict {
        @Override
        public String word() {
            return "invalid";
        }

        @Override
        public String keys() {
            return order.received();
        }

        /** Position of the first digit of the process's number among the keys, from 1: the number precedes the closing. */
        int position() {
            int number = order.process().orElseThrow().number();
            return keys().length() - (number > 9 ? 3 : 2);
        }
    }

    record Invalid(OrderFault fault) implements Verdict {
        @Override
        public String word() {
            return "invalid";
        }

        @Override
        public String keys() {
            return fault.keys();
        }
    }

    /**
     * Verifies an order against the robot's status, by its first instruction; in Moving by its first motion, if any.
     */
    static Verdict of(Order order, RobotStatus status) {
        Instruction decisive = order.instructions().get(0);
        if (status == RobotStatus.MOVING) {
            decisive = order.instructions().stream()
                    .filter(Order::moves)
                    .findFirst()
                    .orElse(decisive);
        }
        StatusRules.Treatment treatment = StatusRules.treatment(status, decisive);
        return treatment == StatusRules.Treatment.EXECUTED
                ? new Accepted(order)
                : new Refused(order, status, treatment.tone());
    }

    /**
     * Verifies an order against the robot's processes, too: a fault of the order itself precedes a refusal by the status.
     *
     * @param processes names by number
     */
    static Verdict of(Order order, RobotStatus status, SortedMap<Integer, String> processes) {
        boolean isThere = order.process()
                .map(Instruction.StartProcess::number)
                .map(processes::containsKey)
                .orElse(true);
        return isThere ? of(order, status) : new NoProcess(order, processes);
    }

    /** Verifies a complete or broken order against status and processes. @throws IllegalArgumentException for a pending one */
    static Verdict of(Recognition recognition, RobotStatus status, SortedMap<Integer, String> processes) {
        return recognition instanceof Recognition.Complete complete
                ? of(complete.order(), status, processes)
                : of(recognition, status);
    }

    /** Verifies a complete or broken order. @throws IllegalArgumentException for a pending one */
    static Verdict of(Recognition recognition, RobotStatus status) {
        if (recognition instanceof Recognition.Complete complete) {
            return of(complete.order(), status);
        }
        if (recognition instanceof Recognition.Broken broken) {
            return new Invalid(broken.fault());
        }
        throw new IllegalArgumentException("the order is not read to its end yet");
    }
}
