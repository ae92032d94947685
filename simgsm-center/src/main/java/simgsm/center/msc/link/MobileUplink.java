package simgsm.center.msc.link;

import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.Cause;
import simgsm.octets.OctetString;

/** Takes what mobiles send, whatever way they are reached by. */
public interface MobileUplink {
    /** The first layer 3 message of a radio connection, or of SAPI 3 on one. */
    void established(Link link, RslMessage.Sapi sapi, OctetString layer3);

    /** A further layer 3 message. */
    void received(Link link, OctetString layer3);

    /** The mobile has left the channel, or is lost. */
    void left(Link link);

    /** A speech frame. */
    void spoke(Link link, IpaFrame frame);

    /** The speech path that a call needs cannot be had. */
    void speechRefused(Link link, Cause cause);
}
