package simrobot.behaviour;

import java.util.ArrayList;
import java.util.List;

/**
 * What a process asked for in one decision; immutable.
 *
 * @param steering null if it returned none
 * @param takesKeys whether it has read the keys of the call
 * @param messages to be sent by SMS
 * @param tones keys to be played to the caller; empty for none
 * @param place where {@link Behaviour#goTo} drives it; empty if it steers itself
 * @param erases whether its earlier drawing goes first
 * @param marks drawn on the floor, at most {@value #MOST_MARKS}
 * @param printed lines of {@code System.out}
 */
public record Requests(
        Steering steering,
        boolean isDone,
        boolean takesKeys,
        List<Message> messages,
        String tones,
        String place,
        boolean erases,
        List<Mark> marks,
        List<String> printed) {
    /** The most lines and texts that a robot's floor shows; the oldest go first. */
    public static final int MOST_MARKS = 500;

    private static final int MOST_TONES = 16;
    private static final int MOST_MESSAGES = 5;
    private static final int MOST_PRINTED = 2000;
    private static final int MOST_TEXT = 60;
    private static final ThreadLocal<Open> NOW = new ThreadLocal<>();

    /** A text to a telephone number. */
    public record Message(String to, String text) {}

    /** A line on the floor between two points, metres; with a text, that text at the first of them. */
    public record Mark(double x, double y, double toX, double toY, String text) {}

    /** Only speeds. */
    public static Requests only(Steering steering) {
        return new Requests(steering, false, false, List.of(), "", "", false, List.of(), List.of());
    }

    /** The same with other speeds. */
    public Requests with(Steering other) {
        return new Requests(other, isDone, takesKeys, messages, tones, place, erases, marks, printed);
    }

    /** Has a process decide, on this thread, and notes what it asks for. */
    public static Requests of(Behaviour behaviour, Senses senses) {
        Open open = new Open();
        NOW.set(open);
        try {
            Steering steering = behaviour.decide(senses);
            boolean isDone = behaviour.isDone();
            return new Requests(
                    steering,
                    isDone,
                    open.takesKeys,
                    List.copyOf(open.messages),
                    open.tones,
                    open.place,
                    open.erases,
                    List.copyOf(open.marks),
                    open.printed.toString().lines().toList());
        } finally {
            NOW.remove();
        }
    }

    /** The process that decides on this thread has read its keys; {@link Senses} note it. */
    public static void noteKeys() {
        if (NOW.get() != null) {
            NOW.get().takesKeys = true;
        }
    }

    /** Notes what the process that decides on this thread prints. @return false if none does */
    public static boolean notePrinted(String text) {
        Open open = NOW.get();
        if (open != null) {
            int left = MOST_PRINTED - open.printed.length();
            open.printed.append(text, 0, Math.min(text.length(), left));
        }
        return open != null;
    }

    /** @throws IllegalStateException outside of a decision */
    static Open now() {
        if (NOW.get() == null) {
            throw new IllegalStateException("expected within decide, on its thread");
        }
        return NOW.get();
    }

    /** The requests of a decision that is being made. */
    static final class Open {
        private final StringBuilder printed = new StringBuilder();
        private final List<Message> messages = new ArrayList<>();
        private final List<Mark> marks = new ArrayList<>();
        private boolean takesKeys;
        private boolean erases;
        private String tones = "";
        private String place = "";

        void send(String number, String text) {
            require(number.matches("\\+?[0-9]{1,15}"), "sms to \"" + number + "\"", "a number of 1 to 15 digits");
            require(!text.isBlank(), "an empty sms", "a text");
            require(messages.size() < MOST_MESSAGES, "more than 5 sms in a decision", "one");
            messages.add(new Message(number, text));
        }

        void play(String keys) {
            tones += keys;
            require(keys.matches("[0-9*#A-D]*"), "play \"" + keys + "\"", "keys of 0 to 9, *, # and A to D");
            require(tones.length() <= MOST_TONES, "play of " + tones.length() + " keys in a decision", "at most 16");
        }

        void goTo(String name) {
            place = name;
        }

        void erase() {
            erases = true;
            marks.clear();
        }

        void draw(double x, double y, double toX, double toY, String text) {
            require(Double.isFinite(x + y + toX + toY), "a drawing at infinity", "metres");
            require(text.length() <= MOST_TEXT, "a drawn text of " + text.length() + " characters", "at most 60");
            marks.add(new Mark(x, y, toX, toY, text));
            if (marks.size() > MOST_MARKS) {
                marks.remove(0);
            }
        }

        private static void require(boolean holds, String found, String expected) {
            if (!holds) {
                throw new IllegalArgumentException(found + ", expected " + expected);
            }
        }
    }
}
