package simgsm.center.bsc;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.abis.MediaPort;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/**
 * The speech of one traffic channel as RTP over UDP between exchange and tower: ip.access CRCX requests the tower's
 * port, MDCX sends ours. Packets of either payload type pass unchanged in both directions.
 */
final class ChannelSpeech {
    private static final System.Logger LOG = System.getLogger(ChannelSpeech.class.getName());

    /** Bits 8-5: direction, 1 for receive only; bits 4-1: codec, 0 for GSM full rate. */
    private static final int RECEIVE_ONLY = 0x10;

    private static final int SEND_AND_RECEIVE = 0x00;

    private final DedicatedChannel channel;
    private MediaPort port;
    private boolean isOpen;
    private boolean isRefused;

    ChannelSpeech(DedicatedChannel channel) {
        this.channel = channel;
    }

    /** Requests a connection of the tower. */
    void create() {
        isRefused = false;
        port = channel.tower().openMedia(channel::heard);
        channel.send(RslPdu.of(RslType.CREATE_CONNECTION, channel.number())
                .with(RslElement.SPEECH_MODE, RECEIVE_ONLY)
                .with(RslElement.RTP_PAYLOAD, RtpPacket.GSM_FULL_RATE));
    }

    /** Handles the tower's answer to CRCX. */
    void created(RslPdu answer) throws ProtocolViolation {
        if (port == null || isOpen) {
            return;
        }
        OctetString identifier = answer.value(RslElement.CONNECTION_IDENTIFIER);
        MediaAddress tower =
                new MediaAddress(text(answer.value(RslElement.LOCAL_IP)), answer.twoOctets(RslElement.LOCAL_PORT));
        Optional<MediaAddress> own = port.openMedia();
        if (own.isEmpty()) {
            refused("no UDP port of our own is free");
            return;
        }
        isOpen = port.connectMedia(tower);
        if (isOpen) {
            channel.send(RslPdu.of(RslType.MODIFY_CONNECTION, channel.number())
                    .with(RslElement.CONNECTION_IDENTIFIER, identifier)
                    .with(RslElement.REMOTE_IP, octets(own.get().host()))
                    .with(
                            RslElement.REMOTE_PORT,
                            own.get().port() >> 8,
                            own.get().port())
                    .with(RslElement.SPEECH_MODE, SEND_AND_RECEIVE)
                    .with(RslElement.RTP_PAYLOAD, RtpPacket.GSM_FULL_RATE));
        } else {
            String reason = "it offers speech at " + tower + ", which is not on its own host";
            channel.tower().violated(reason);
            refused(reason);
        }
    }

    private static String text(OctetString ip) {
        return ip.octet(0) + "." + ip.octet(1) + "." + ip.octet(2) + "." + ip.octet(3);
    }

    private static int[] octets(String host) {
        String[] parts = host.split("\\.");
        int[] octets = new int[4];
        for (int i = 0; i < octets.length && parts.length == octets.length; i++) {
            octets[i] = Integer.parseInt(parts[i]);
        }
        return octets;
    }

    /** Handles a tower without resources for speech, which is no protocol error. */
    void refused() {
        refused("the tower refuses it");
    }

    private void refused(String reason) {
        if (port != null && !isRefused) {
            LOG.log(Level.WARNING, "{0}: no speech, {1}", channel, reason);
            isOpen = false;
            isRefused = true;
            channel.speechRefused();
        }
    }

    /** True if this activation of the channel has no speech and will have none. */
    boolean isRefused() {
        return isRefused;
    }

    /**
     * Sends a packet.
     *
     * @return false if the path is not connected yet
     */
    boolean send(byte[] rtp) {
        return isOpen && port.sendMedia(rtp);
    }

    /** Ends the channel, and with it the tower's connection. */
    void close() {
        isOpen = false;
        isRefused = false;
        if (port != null) {
            port.closeMedia();
            port = null;
        }
    }
}
