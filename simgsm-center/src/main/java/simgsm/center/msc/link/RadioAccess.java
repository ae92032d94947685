package simgsm.center.msc.link;

import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.octets.OctetString;

/** The exchange's access to one mobile: the link of a terminal with its own cell, or towers. */
public interface RadioAccess {
    /** Degrees of need for speech, the smallest first. */
    enum SpeechNeed {
        NONE,
        /** A traffic channel must be ready when the called party answers. */
        PREPARED,
        /** The mobile may hear something. */
        HEARD
    }

    /** Sends a layer 3 message on the radio connection; without one it is dropped. */
    void send(RslMessage.Sapi sapi, OctetString layer3);

    /** Ends the radio connection with CHANNEL RELEASE; {@link NetworkRadioConnection#left} follows. */
    void release();

    /** Pages the mobile once. */
    void page(MobileIdentity identity);

    /** The channel of the mobile's cell broadcast. */
    BroadcastChannel broadcastChannel();

    /** The location area of the mobile's last activity. */
    LocationArea area();

    /** Sets the need for a speech path. {@link MobileUplink#speechRefused} follows if there is none. */
    void setSpeechNeed(SpeechNeed need);

    /** Sends speech if there is a path for it. */
    void sendSpeech(IpaFrame frame);

    /**
     * Ciphers the radio connection.
     *
     * @param done receives true once the mobile has begun to cipher; false at once where it does already, and where that is not
     *     possible: on a terminal's own link, and for a mobile without an algorithm
     */
    default void cipher(OctetString kc, Consumer<Boolean> done) {
        done.accept(false);
    }

    /** True while the radio connection is ciphered. */
    default boolean isCiphered() {
        return false;
    }

    /** True if the mobile is reached by towers, which other mobiles share. */
    boolean isShared();

    /**
     * Takes over the radio connection of another access, which proved to be this mobile's; an older one is lost. Over
     * towers only.
     */
    default void takeOver(RadioAccess other) {
        throw new IllegalStateException("a terminal's own link has no other's connection");
    }

    /** Ends the access with the mobile's link. */
    void close(String reason);
}
