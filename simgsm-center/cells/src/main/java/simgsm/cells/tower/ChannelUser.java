package simgsm.cells.tower;

import simgsm.air.CipherAlgorithm;
import simgsm.cells.cipher.CipherKey;
import simgsm.octets.OctetString;

/** The mobile on a dedicated channel. */
public interface ChannelUser {
    /** A message of layer 3 for the mobile. @param sapi 0 or 3 */
    void layer3Arrived(TowerChannel channel, int sapi, OctetString layer3);

    /** An RTP packet with speech for the mobile. */
    void speechArrived(TowerChannel channel, byte[] rtp);

    /** PHYSICAL INFORMATION answers the mobile's HANDOVER ACCESS. */
    void physicalInformation(TowerChannel channel, int timingAdvance);

    /** The key with which the mobile ciphers now. */
    CipherKey key();

    /** The mobile has completed a command to cipher. @param algorithm A5/0 if ciphering has ended */
    void ciphered(CipherAlgorithm algorithm);

    /** The channel has ended. */
    void channelLost(TowerChannel channel);
}
