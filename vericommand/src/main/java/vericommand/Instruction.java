package vericommand;

/** One instruction of an order, in the operator's units; constructors throw for values out of range. */
public sealed interface Instruction {
    /** The instruction as keys, without leading zeros: {@code #**20}. */
    String keys();

    /** An instruction that moves the robot. */
    sealed interface Motion extends Instruction {
        /** Centimetres of a {@link Forward}, degrees of a {@link Turn}. */
        int amount();
    }

    /** Move straight ahead, 1..9999 cm. */
    record Forward(int centimeters) implements Motion {
        public static final int MAX_CENTIMETERS = 9999;

        public Forward {
            requireRange("centimetres", centimeters, MAX_CENTIMETERS);
        }

        @Override
        public int amount() {
            return centimeters;
        }

        @Override
        public String keys() {
            return "#**" + centimeters;
        }
    }

    /** Turn on the spot, 1..360 degrees clockwise as seen from above. */
    record Turn(int clockwiseDegrees) implements Motion {
        public static final int MAX_DEGREES = 360;

        public Turn {
            requireRange("degrees", clockwiseDegrees, MAX_DEGREES);
        }

        @Override
        public int amount() {
            return clockwiseDegrees;
        }

        @Override
        public String keys() {
            return "#*#" + clockwiseDegrees;
        }
    }

    /** Brake now; an order without motions is accepted while the robot moves. */
    record StopNow() implements Instruction {
        @Override
        public String keys() {
            return "###";
        }
    }

    /** Report the status. */
    record ReportStatus() implements Instruction {
        @Override
        public String keys() {
            return "#*0";
        }
    }

    /** Start the robot's process with this number, 1..99; the last instruction of its order. */
    record StartProcess(int number) implements Instruction {
        public static final int MAX_NUMBER = 99;

        public StartProcess {
            requireRange("the number of a process", number, MAX_NUMBER);
        }

        @Override
        public String keys() {
            return "#*" + number;
        }
    }

    private static void requireRange(String what, int value, int max) {
        if (value < 1 || value > max) {
            throw new IllegalArgumentException(what + " must be 1.." + max + ", not " + value);
        }
    }
}
