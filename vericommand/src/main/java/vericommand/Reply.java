package vericommand;

/**
 * The reply to an order: the tone in a call, {@link #message()} in a short message.
 *
 * @param text the tone's meaning and details, without its number
 */
public record Reply(ReplyTone tone, String text) {
    /** One short message of the GSM alphabet. */
    public static final int MAX_MESSAGE_CHARACTERS = 160;

    public Reply {
        if (text.length() > MAX_MESSAGE_CHARACTERS - 2) {
            throw new IllegalArgumentException("a reply fits one short message: " + text);
        }
    }

    /** The text of the reply SMS. */
    public String message() {
        return tone.number() + " " + text;
    }
}
