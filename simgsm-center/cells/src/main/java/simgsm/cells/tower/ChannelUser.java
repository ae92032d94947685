package simgsm.cells.tower;

import simgsm.octets.OctetString;

/** The mobile on a dedicated channel. */
public interface ChannelUser {
    /** A message of layer 3 for the mobile. @param sapi 0 or 3 */
    void layer3Arrived(TowerChannel channel, int sapi, OctetString layer3);

    /** An RTP packet with speech for the mobile. */
    void speechArrived(TowerChannel channel, byte[] rtp);

    /** PHYSICAL INFORMATION answers the mobile's HANDOVER ACCESS. */
    void physicalInformation(TowerChannel channel, int timingAdvance);

    /** The channel has ended. */
    void channelLost(TowerChannel channel);
}
