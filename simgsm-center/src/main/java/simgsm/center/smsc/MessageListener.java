package simgsm.center.smsc;

/** Hears what becomes of messages. */
public interface MessageListener {
    void changed(ShortMessage message, MessageState state);
}
