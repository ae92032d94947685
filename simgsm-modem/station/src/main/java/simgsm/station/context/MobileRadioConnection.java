package simgsm.station.context;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.Sapi;
import simgsm.air.CallControl;
import simgsm.air.CipherAlgorithm;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.MobilityManagement;
import simgsm.air.RadioResource.CipheringModeCommand;
import simgsm.air.ShortMessageControl;
import simgsm.air.SupplementaryService;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** The one radio connection shared by calls, short messages and registration. The first message sent opens it. */
public final class MobileRadioConnection {
    private final StationLog log;
    private final PendingEvents events;
    private Uplink uplink = Uplink.DISCONNECTED;
    private boolean open;
    private boolean isCiphered;
    /** True if the centre has ended the media: the call is ending, and its last speech is dropped. */
    private boolean isMediaEnded;
    /** N(SD) of the next message that carries one (TS 24.007, 11.2.3.2.3). */
    private int sendSequence;

    MobileRadioConnection(StationLog log, PendingEvents events) {
        this.log = log;
        this.events = events;
    }

    /** @param newUplink the new connection to the centre */
    public void setUplink(Uplink newUplink) {
        uplink = newUplink;
        open = false;
        isMediaEnded = false;
    }

    public boolean isOpen() {
        return open;
    }

    /** True if the open connection is ciphered. */
    public boolean isCiphered() {
        return isCiphered;
    }

    /** Ciphers the open connection with the card's key, or no longer with A5/0; the towers cipher the air with it. */
    public void cipher(CipheringModeCommand command, Optional<OctetString> kc) {
        isCiphered = command.algorithm() != CipherAlgorithm.A5_0;
        OctetWriter information = new OctetWriter().octet(command.algorithm().rsl());
        if (isCiphered) {
            information.string(kc.orElseThrow());
        }
        send(new RslMessage.EncryptionCommand(
                information.toOctetString(), OctetString.of(Layer3Codec.encode(command, Direction.DOWNLINK, 0))));
    }

    public void send(Layer3Message message) {
        OctetString octets = OctetString.of(Layer3Codec.encode(message, Direction.UPLINK, nextSequence(message)));
        Sapi sapi = message instanceof ShortMessageControl ? Sapi.SHORT_MESSAGES : Sapi.SIGNALLING;
        log.trace(Level.DEBUG, "up {0}", message);
        events.add(new StationEvent.MessagePassed(Direction.UPLINK, message));
        isCiphered &= open;
        send(open ? new RslMessage.DataIndication(sapi, octets) : new RslMessage.EstablishIndication(sapi, octets));
        open = true;
    }

    /**
     * Sends a frame on a stream that needs no radio connection; speech by the open media, if any, and not at all once
     * the centre has ended them.
     */
    public void send(int stream, byte[] payload) {
        boolean isSpeech = stream == IpaFrame.SPEECH;
        if (isSpeech && (isMediaEnded || uplink.sendMedia(payload))) {
            return;
        }
        uplink.send(new IpaFrame(stream, payload));
    }

    /** Opens media to the centre. @return address of reception; empty if impossible */
    public Optional<MediaAddress> openMedia(MediaAddress center) {
        isMediaEnded = false;
        Optional<MediaAddress> own = uplink.openMedia();
        if (own.isPresent() && !uplink.connectMedia(center)) {
            uplink.closeMedia();
            return Optional.empty();
        }
        return own;
    }

    public void closeMedia() {
        isMediaEnded = true;
        uplink.closeMedia();
    }

    /** Leaves the channel, if any. */
    public void release() {
        if (open) {
            open = false;
            send(new RslMessage.ReleaseIndication(Sapi.SIGNALLING));
        }
    }

    /** Ends the connection to the centre. */
    public void dropLink() {
        uplink.drop();
    }

    private int nextSequence(Layer3Message message) {
        if (!open) {
            sendSequence = 0;
        }
        int sequence = sendSequence;
        if (message instanceof MobilityManagement
                || message instanceof CallControl
                || message instanceof SupplementaryService) {
            sendSequence ^= 1;
        }
        return sequence;
    }

    private void send(RslMessage message) {
        send(IpaFrame.RSL, message.encode());
    }
}
