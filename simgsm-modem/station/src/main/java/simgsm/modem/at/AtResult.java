package simgsm.modem.at;

/** The final result of a command, or an unsolicited code such as RING (V.250, 5.7.1). */
public sealed interface AtResult {
    Plain OK = new Plain("OK", 0);
    Plain RING = new Plain("RING", 2);
    Plain NO_CARRIER = new Plain("NO CARRIER", 3);
    Plain ERROR = new Plain("ERROR", 4);
    Plain BUSY = new Plain("BUSY", 7);
    Plain NORMAL_POWER_DOWN = new Plain("NORMAL POWER DOWN", 4);
    Plain NO_ANSWER = new Plain("NO ANSWER", 8);

    /** Not a result yet; {@link AtRequest#finish} sets it later. */
    Plain PENDING = new Plain("", -1);

    /** @param number the code's short form, for V0 */
    record Plain(String words, int number) implements AtResult {}

    /** An error in the form set by +CMEE. */
    record EquipmentError(CmeError error) implements AtResult {}

    /** @param code a {@link CmsError}, or a cause of TS 24.011 */
    record MessageError(int code) implements AtResult {}

    /** The text of the result: in words, or for V0 as a number if it has one. */
    default String text(boolean inWords, int errorMode) {
        if (this instanceof Plain plain) {
            return inWords ? plain.words() : Integer.toString(plain.number());
        }
        if (this instanceof MessageError error) {
            return "+CMS ERROR: " + error.code();
        }
        CmeError error = ((EquipmentError) this).error();
        return switch (errorMode) {
            case 0 -> ERROR.text(inWords, errorMode);
            case 1 -> "+CME ERROR: " + error.code();
            default -> "+CME ERROR: " + error.words();
        };
    }
}
