package simgsm.center.msc.link;

import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.octets.OctetString;

/** How the exchange reaches one mobile: by the link of a terminal that carries its own cell, or by towers. */
public interface RadioAccess {
    /** What a mobile's calls need of speech, the least first. */
    enum SpeechNeed {
        NONE,
        /** A traffic channel has to be there when the called party answers. */
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

    /** Where the mobile hears cell broadcast. */
    BroadcastChannel broadcastChannel();

    /** The location area in which the mobile was last seen. */
    LocationArea area();

    /** How far a call needs a speech path. {@link MobileUplink#speechRefused} follows if there is none. */
    void setSpeechNeed(SpeechNeed need);

    /** Sends speech if there is a path for it. */
    void sendSpeech(IpaFrame frame);

    /** Whether the mobile is reached by towers, which other mobiles use too. */
    boolean isShared();

    /** The radio connection of another mobile's access turns out to be this mobile's; an older one is lost. Over towers only. */
    default void takeOver(RadioAccess other) {
        throw new IllegalStateException("a terminal's own link has no other's connection");
    }

    /** The mobile's link is over. */
    void close(String reason);
}
