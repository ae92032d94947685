package vericommand;

import java.util.ArrayList;
import java.util.List;

/**
 * Reads orders from keys, one key at a time:
 *
 * <pre>
 *   order       = "**" { "*" } instruction { instruction } "**"
 *   instruction = "#**" number | "#*#" number | "###" | "#*0"
 *   number      = 1 to 4 digits
 * </pre>
 *
 * A broken order is told once, at the offending key; then keys are skipped to the next {@code **} whose first {@code *}
 * does not directly follow a {@code #}. So neither the {@code **} of an instruction nor the closing of the broken order
 * can be taken for the start of something: the closing opens an empty order, and an empty order may grow further stars.
 */
public final class CommandRecognizer {
    /** 10 s of speech at 8 kHz. */
    public static final long TIMEOUT_SAMPLES = 80_000;

    private static final int MAX_DIGITS = 4;
    private static final char NO_KEY = 0;

    private enum State {
        IDLE(Expected.OPENING),
        /** One star of an opening. */
        STAR(Expected.STAR),
        OPENED(Expected.HASH),
        HASH(Expected.STAR_OR_HASH),
        HASH_STAR(Expected.STAR_HASH_OR_ZERO),
        HASH_HASH(Expected.HASH),
        NUMBER(Expected.NUMBER),
        INSTRUCTION_READ(Expected.HASH_OR_STAR),
        CLOSING(Expected.STAR),
        SKIPPING(Expected.OPENING),
        SKIPPING_STAR(Expected.STAR);

        private final Expected expected;

        State(Expected expected) {
            this.expected = expected;
        }
    }

    private State state = State.IDLE;
    private final StringBuilder keys = new StringBuilder();
    private final List<Instruction> instructions = new ArrayList<>();
    private final StringBuilder digits = new StringBuilder();
    private boolean turning;
    private char previousKey = NO_KEY;
    private long silentSamples;

    /** Nothing heard yet. */
    public CommandRecognizer() {}

    /** Forgets everything, as at the end of a call. */
    public void reset() {
        state = State.IDLE;
        keys.setLength(0);
        previousKey = NO_KEY;
        silentSamples = 0;
    }

    /** Whether an order is open: its opening has come, its closing has not. */
    public boolean isOpen() {
        return switch (state) {
            case IDLE, STAR, SKIPPING, SKIPPING_STAR -> false;
            default -> true;
        };
    }

    /** The keys of the open order. */
    public String keys() {
        return keys.toString();
    }

    /** Takes the next key; characters that are no telephone keys never fit. */
    public Recognition key(char key) {
        silentSamples = 0;
        Recognition recognition = read(key);
        previousKey = key;
        return recognition;
    }

    /** Tells how much speech has come since the last call; an order begun and left for 10 s is dropped. */
    public Recognition elapsed(long samples) {
        silentSamples += samples;
        if (silentSamples < TIMEOUT_SAMPLES) {
            return Recognition.PENDING;
        }
        if (!isOpen() || state == State.OPENED) {
            // So long after a stray # whoever begins again is not kept from it.
            previousKey = isOpen() ? previousKey : NO_KEY;
            return Recognition.PENDING;
        }
        Fault missing = missing();
        state = State.SKIPPING;
        previousKey = NO_KEY;
        return new Recognition.Broken(
                new Fault(missing.keys(), missing.position(), missing.expected(), missing.limit(), true));
    }

    /** What the next key would have to be: the fault of an order that ends here. */
    Fault missing() {
        Expected expected = state == State.NUMBER && !digits.isEmpty() ? Expected.DIGIT_HASH_OR_STAR : state.expected;
        boolean numberMissing = state == State.NUMBER && !numberIsInRange();
        return new Fault(
                keys(),
                keys.length() + 1,
                numberMissing ? Expected.NUMBER : expected,
                numberMissing ? rangeLimit() : Fault.Limit.NONE,
                false);
    }

    private Recognition read(char key) {
        return switch (state) {
            case IDLE -> become(key == '*' ? State.STAR : State.IDLE, key);
            case STAR -> become(key == '*' ? State.OPENED : State.IDLE, key);
            case OPENED -> readOpened(key);
            case HASH -> readHash(key);
            case HASH_STAR -> readHashStar(key);
            case HASH_HASH -> key == '#' ? add(new Instruction.Stop(), key) : broken(key);
            case NUMBER -> readNumber(key);
            case INSTRUCTION_READ -> readNext(key, Expected.HASH_OR_STAR);
            case CLOSING -> key == '*' ? complete() : broken(key);
            case SKIPPING, SKIPPING_STAR -> skip(key);
        };
    }

    private Recognition become(State next, char key) {
        if (next == State.IDLE || next == State.STAR) {
            keys.setLength(0);
        }
        if (next == State.OPENED && state != State.OPENED) {
            instructions.clear();
        }
        if (next != State.IDLE) {
            keys.append(key);
        }
        state = next;
        return Recognition.PENDING;
    }

    private Recognition readOpened(char key) {
        return switch (key) {
            case '*' -> become(State.OPENED, key);
            case '#' -> become(State.HASH, key);
            default -> broken(key);
        };
    }

    private Recognition readHash(char key) {
        return switch (key) {
            case '*' -> become(State.HASH_STAR, key);
            case '#' -> become(State.HASH_HASH, key);
            default -> broken(key);
        };
    }

    private Recognition readHashStar(char key) {
        return switch (key) {
            case '*', '#' -> {
                turning = key == '#';
                digits.setLength(0);
                yield become(State.NUMBER, key);
            }
            case '0' -> add(new Instruction.Report(), key);
            default -> broken(key);
        };
    }

    private Recognition readNumber(char key) {
        if (key >= '0' && key <= '9') {
            if (digits.length() == MAX_DIGITS) {
                return broken(key, Expected.HASH_OR_STAR, rangeLimit());
            }
            digits.append(key);
            return become(State.NUMBER, key);
        }
        if (!numberIsInRange()) {
            return broken(key, Expected.NUMBER, rangeLimit());
        }
        int number = Integer.parseInt(digits.toString());
        instructions.add(turning ? new Instruction.Turn(number) : new Instruction.Forward(number));
        return readNext(key, digits.length() < MAX_DIGITS ? Expected.DIGIT_HASH_OR_STAR : Expected.HASH_OR_STAR);
    }

    private boolean numberIsInRange() {
        if (digits.isEmpty()) {
            return false;
        }
        int number = Integer.parseInt(digits.toString());
        return number >= 1 && number <= (turning ? Instruction.Turn.MAX_DEGREES : Instruction.Forward.MAX_CENTIMETERS);
    }

    private Fault.Limit rangeLimit() {
        return turning ? Fault.Limit.DEGREES : Fault.Limit.CENTIMETERS;
    }

    private Recognition add(Instruction instruction, char key) {
        instructions.add(instruction);
        return become(State.INSTRUCTION_READ, key);
    }

    /** Behind a whole instruction: the next one or the closing. */
    private Recognition readNext(char key, Expected expected) {
        return switch (key) {
            case '*' -> become(State.CLOSING, key);
            case '#' ->
                instructions.size() < Order.MAX_INSTRUCTIONS
                        ? become(State.HASH, key)
                        : broken(key, Expected.CLOSING, Fault.Limit.INSTRUCTIONS);
            default -> broken(key, expected, Fault.Limit.NONE);
        };
    }

    private Recognition complete() {
        int stars = keys.indexOf("#");
        Order order = new Order(keys.append('*').substring(stars - 2), instructions);
        state = State.IDLE;
        keys.setLength(0);
        return new Recognition.Complete(order);
    }

    private Recognition broken(char key) {
        return broken(key, state.expected, Fault.Limit.NONE);
    }

    private Recognition broken(char key, Expected expected, Fault.Limit limit) {
        Fault fault = new Fault(keys.append(key).toString(), keys.length(), expected, limit, false);
        state = State.SKIPPING;
        skip(key);
        return new Recognition.Broken(fault);
    }

    /** The offending key itself is skipped by the same rule: it may be the first star. */
    private Recognition skip(char key) {
        if (key != '*') {
            state = State.SKIPPING;
            return Recognition.PENDING;
        }
        if (state == State.SKIPPING_STAR) {
            keys.setLength(0);
            keys.append('*');
            return become(State.OPENED, key);
        }
        state = previousKey == '#' ? State.SKIPPING : State.SKIPPING_STAR;
        return Recognition.PENDING;
    }
}
