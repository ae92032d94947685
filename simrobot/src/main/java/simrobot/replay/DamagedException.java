package simrobot.replay;

/** A record with a correct checksum has an impossible content, named in the text. */
public final class DamagedException extends RuntimeException {
    DamagedException(String message) {
        super(message);
    }
}
