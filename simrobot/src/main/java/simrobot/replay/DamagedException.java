package simrobot.replay;

/** A record with a correct checksum has invalid content, named in the text. */
public final class DamagedException extends RuntimeException {
    DamagedException(String message) {
        super(message);
    }
}
