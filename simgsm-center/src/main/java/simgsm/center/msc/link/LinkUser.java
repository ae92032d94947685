package simgsm.center.msc.link;

/** A protocol above the links: mobility management, call control, short messages, supplementary services. */
public interface LinkUser {
    /** True if a transaction uses the link's radio connection, which is released otherwise. */
    boolean needsRadio(Link link);

    /** True if no further transaction may begin on the radio connection. */
    default boolean reservesRadio(Link link) {
        return false;
    }

    /** The radio connection is lost, or unavailable: all transactions on the link end. */
    void radioLost(Link link);

    /** The link is closed; called after {@link #radioLost}. */
    default void linkClosed(Link link) {}
}
