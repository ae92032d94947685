package simgsm.modem.at;

/** Ends a command with a result other than OK. */
public final class AtException extends Exception {
    private static final long serialVersionUID = 1;

    private final transient AtResult result;

    public AtException(AtResult result) {
        super(result.text(true, 2), null, false, false);
        this.result = result;
    }

    public AtException(CmeError error) {
        this(new AtResult.EquipmentError(error));
    }

    /** The result of a message command. @param code a {@link CmsError} */
    public static AtException ofMessage(int code) {
        return new AtException(new AtResult.MessageError(code));
    }

    public AtResult result() {
        return result;
    }
}
