package simrobot.behaviour;

/** A request of a process in addition to the speeds of its wheels. */
public sealed interface BehaviourRequest {
    /** The keys of the call: from now on they are the process's. */
    record Keys() implements BehaviourRequest {}

    /** An SMS. @param to 1 to 15 digits, a plus sign before them if it is international */
    record Sms(String to, String text) implements BehaviourRequest {
        public Sms {
            require(to.matches("\\+?[0-9]{1,15}"), "sms to \"" + to + "\", expected a number of 1 to 15 digits");
            require(!text.isBlank(), "an empty sms, expected a text");
            require(text.length() <= 160, "an sms of " + text.length() + " characters, expected at most 160");
        }
    }

    /** Tones to the caller. */
    record Tones(String keys) implements BehaviourRequest {
        public Tones {
            require(keys.matches("[0-9*#A-D]{1,16}"), "play \"" + keys + "\", expected 1 to 16 of 0-9 * # A-D");
        }
    }

    /** A drive to a goal, dock or home of the world, by its name. */
    record DriveTo(String place) implements BehaviourRequest {}

    /** A line on the floor, metres; with a text, that text at the line's first end. */
    record Mark(double x, double y, double toX, double toY, String text) implements BehaviourRequest {
        /** The most that a robot's floor shows: the newest. */
        public static final int MOST = 500;

        public Mark {
            require(Double.isFinite(x + y + toX + toY), "a drawing at infinity, expected metres");
            require(text.length() <= 60, "drawText of " + text.length() + " characters, expected at most 60");
        }
    }

    /** Whole lines of {@code System.out}. */
    record Printed(String text) implements BehaviourRequest {}

    private static void require(boolean holds, String fault) {
        if (!holds) {
            throw new IllegalArgumentException(fault);
        }
    }
}
