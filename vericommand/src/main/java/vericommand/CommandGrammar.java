package vericommand;

import static vericommand.CommandGrammar.GrammarAction.*;
import static vericommand.CommandGrammar.KeyClass.*;
import static vericommand.CommandGrammar.Place.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/**
 * The grammar of an order as a state table: a state is a place in the grammar, an event is a class of key.
 *
 * <pre>
 *   order       = "**" { "*" } instruction { instruction } "**"
 *   instruction = "#**" number | "#*#" number | "###" | "#*0" | "#*1" .. "#*99" (the last one only)
 *   number      = 1 to 4 digits
 * </pre>
 *
 * In an open order a key without a row is a fault. The limits (a number's range and digits, 32 instructions) are not in
 * the table; {@link CommandRecognizer} checks them.
 */
public final class CommandGrammar {
    /** A place in the grammar, named after the key class read last. */
    public enum Place {
        IDLE(ExpectedKeys.OPENING),
        FIRST_STAR(ExpectedKeys.STAR),
        OPENED(ExpectedKeys.HASH),
        HASH_READ(ExpectedKeys.STAR_OR_HASH),
        HASH_STAR(ExpectedKeys.STAR_HASH_OR_DIGIT),
        HASH_HASH(ExpectedKeys.HASH),
        FORWARD(ExpectedKeys.NUMBER, OrderFault.Limit.CENTIMETERS),
        TURN(ExpectedKeys.NUMBER, OrderFault.Limit.DEGREES),
        CENTIMETERS(ExpectedKeys.DIGIT_HASH_OR_STAR, OrderFault.Limit.CENTIMETERS),
        DEGREES(ExpectedKeys.DIGIT_HASH_OR_STAR, OrderFault.Limit.DEGREES),
        INSTRUCTION_READ(ExpectedKeys.HASH_OR_STAR),
        /** The number of a process has one or two digits. */
        PROCESS_DIGIT(ExpectedKeys.DIGIT_OR_CLOSING),
        /** A process is the last instruction. */
        PROCESS_READ(ExpectedKeys.CLOSING),
        FIRST_CLOSING_STAR(ExpectedKeys.STAR),
        /** After a fault: looks for the next opening. */
        SKIPPING(ExpectedKeys.OPENING),
        /** A {@code *} that directly follows this {@code #} opens nothing. */
        SKIPPING_HASH(ExpectedKeys.OPENING),
        SKIPPING_STAR(ExpectedKeys.STAR);

        private final ExpectedKeys expected;
        private final OrderFault.Limit range;

        Place(ExpectedKeys expected) {
            this(expected, OrderFault.Limit.NONE);
        }

        Place(ExpectedKeys expected, OrderFault.Limit range) {
            this.expected = expected;
            this.range = range;
        }

        ExpectedKeys expected() {
            return expected;
        }

        /** The range of the number read here; NONE if none is. */
        OrderFault.Limit range() {
            return range;
        }
    }

    /** A class of key, or one of the two other events. */
    public enum KeyClass {
        STAR("*"),
        HASH("#"),
        ZERO("0"),
        DIGIT("1..9"),
        /** {@code A B C D}, and every character that is no telephone key. */
        OTHER("other"),
        /** The key does not fit, or exceeds a limit; the key itself follows as an event of its own. */
        FAULT("fault"),
        TIMEOUT("10 s without a key");

        private final String text;

        KeyClass(String text) {
            this.text = text;
        }

        static KeyClass of(char key) {
            return switch (key) {
                case '*' -> STAR;
                case '#' -> HASH;
                case '0' -> ZERO;
                default -> key >= '1' && key <= '9' ? DIGIT : OTHER;
            };
        }
    }

    /** Contribution of a key to the order. */
    public enum GrammarAction {
        OPEN_ORDER,
        ADD_DIGIT,
        ADD_FORWARD,
        ADD_TURN,
        ADD_STOP,
        ADD_REPORT,
        ADD_PROCESS,
        ADD_PROCESS_DIGIT,
        COMPLETE_ORDER
    }

    static final Set<Place> OPEN = EnumSet.range(OPENED, FIRST_CLOSING_STAR);
    static final Set<KeyClass> DIGITS = EnumSet.of(ZERO, DIGIT);

    private static final Set<KeyClass> NO_STAR = EnumSet.of(HASH, ZERO, DIGIT, OTHER);
    private static final Set<KeyClass> NO_STAR_OR_HASH = EnumSet.of(ZERO, DIGIT, OTHER);
    private static final Set<Place> ANY_SKIPPING = EnumSet.range(SKIPPING, SKIPPING_STAR);

    /**
     * After a fault, keys are skipped to the next {@code **} whose first {@code *} does not directly follow a {@code #}: the
     * {@code **} of an instruction opens nothing, and the closing of the broken order opens an empty order, which accepts
     * further stars. The offending key itself is skipped by the same rule, so it may be the first star.
     */
    public static final StateTable<Place, KeyClass, GrammarAction> TABLE = new StateTable<
                    Place, KeyClass, GrammarAction>("command grammar", IDLE)
            .on(IDLE, STAR, FIRST_STAR)
            .on(FIRST_STAR, STAR, OPENED, OPEN_ORDER)
            .on(EnumSet.of(FIRST_STAR), NO_STAR, IDLE)
            .on(OPENED, STAR, OPENED)
            .on(OPENED, HASH, HASH_READ)
            .on(HASH_READ, STAR, HASH_STAR)
            .on(HASH_READ, HASH, HASH_HASH)
            .on(HASH_STAR, STAR, FORWARD)
            .on(HASH_STAR, HASH, TURN)
            .on(HASH_STAR, ZERO, INSTRUCTION_READ, ADD_REPORT)
            .on(HASH_STAR, DIGIT, PROCESS_DIGIT, ADD_PROCESS)
            .on(EnumSet.of(PROCESS_DIGIT), DIGITS, PROCESS_READ, ADD_PROCESS_DIGIT)
            .on(HASH_HASH, HASH, INSTRUCTION_READ, ADD_STOP)
            .on(EnumSet.of(FORWARD, CENTIMETERS), DIGITS, CENTIMETERS, ADD_DIGIT)
            .on(EnumSet.of(TURN, DEGREES), DIGITS, DEGREES, ADD_DIGIT)
            .on(CENTIMETERS, HASH, HASH_READ, ADD_FORWARD)
            .on(CENTIMETERS, STAR, FIRST_CLOSING_STAR, ADD_FORWARD)
            .on(DEGREES, HASH, HASH_READ, ADD_TURN)
            .on(DEGREES, STAR, FIRST_CLOSING_STAR, ADD_TURN)
            .on(INSTRUCTION_READ, HASH, HASH_READ)
            .on(INSTRUCTION_READ, STAR, FIRST_CLOSING_STAR)
            .on(PROCESS_DIGIT, STAR, FIRST_CLOSING_STAR)
            .on(PROCESS_READ, STAR, FIRST_CLOSING_STAR)
            .on(FIRST_CLOSING_STAR, STAR, IDLE, COMPLETE_ORDER)
            .on(EnumSet.of(HASH_HASH, TURN), FAULT, SKIPPING_HASH)
            .on(
                    EnumSet.of(
                            OPENED,
                            HASH_READ,
                            HASH_STAR,
                            FORWARD,
                            CENTIMETERS,
                            DEGREES,
                            INSTRUCTION_READ,
                            PROCESS_DIGIT,
                            PROCESS_READ,
                            FIRST_CLOSING_STAR),
                    FAULT,
                    SKIPPING)
            .on(EnumSet.range(HASH_READ, FIRST_CLOSING_STAR), TIMEOUT, SKIPPING)
            .on(SKIPPING_HASH, TIMEOUT, SKIPPING)
            .on(ANY_SKIPPING, HASH, SKIPPING_HASH)
            .on(ANY_SKIPPING, NO_STAR_OR_HASH, SKIPPING)
            .on(SKIPPING, STAR, SKIPPING_STAR)
            .on(SKIPPING_HASH, STAR, SKIPPING)
            .on(SKIPPING_STAR, STAR, OPENED, OPEN_ORDER)
            .texts(Place::name, key -> key.text);

    private CommandGrammar() {}
}
