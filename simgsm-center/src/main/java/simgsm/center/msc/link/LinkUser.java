package simgsm.center.msc.link;

/** A protocol on top of links: mobility management, call control, short messages, supplementary services. */
public interface LinkUser {
    /** Whether a transaction uses the link's radio connection, which is released otherwise. */
    boolean needsRadio(Link link);

    /** Whether no further transaction may begin on the radio connection. */
    default boolean reservesRadio(Link link) {
        return false;
    }

    /** The radio connection is lost, or cannot be had: all transactions on the link end. */
    void radioLost(Link link);

    /** The link is closed; {@link #radioLost} was called before. */
    default void linkClosed(Link link) {}
}
