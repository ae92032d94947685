package vericommand;

/**
 * The reason that a sequence of keys is not a valid order.
 *
 * @param keys of a call: up to the offending key; of a short message: all
 * @param position of the offending key (or of the missing one), counted from 1 at the order's first {@code *}; in a
 *     short message from the first key of the text; blanks not counted
 * @param limit the limit that the reply names
 */
public record OrderFault(String keys, int position, ExpectedKeys expected, Limit limit, boolean timedOut) {
    /** The limit that an order exceeds. */
    public enum Limit {
        NONE(0),
        CENTIMETERS(Instruction.Forward.MAX_CENTIMETERS),
        DEGREES(Instruction.Turn.MAX_DEGREES),
        INSTRUCTIONS(Order.MAX_INSTRUCTIONS);

        private final int max;

        Limit(int max) {
            this.max = max;
        }

        int max() {
            return max;
        }
    }

    public OrderFault {
        if (position < 1) {
            throw new IllegalArgumentException("positions count from 1, not " + position);
        }
    }
}
