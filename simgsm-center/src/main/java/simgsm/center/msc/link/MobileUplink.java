package simgsm.center.msc.link;

import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.Cause;
import simgsm.octets.OctetString;

/** Receives the messages of mobiles on any access. */
public interface MobileUplink {
    /** The first layer 3 message of a radio connection, or of SAPI 3. */
    void established(Link link, RslMessage.Sapi sapi, OctetString layer3);

    /** A further layer 3 message. */
    void received(Link link, OctetString layer3);

    /** The mobile has left the channel, or is lost. */
    void left(Link link);

    /** A speech frame. */
    void spoke(Link link, IpaFrame frame);

    /** The speech path of a call is unavailable. */
    void speechRefused(Link link, Cause cause);
}
