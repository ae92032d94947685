package simgsm.cells.capture;

import java.util.List;
import java.util.Optional;
import simgsm.air.ChannelNumber;
import simgsm.cells.cipher.CipherKey;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The capture of one dedicated channel. The town has no link layer and passes messages at once; here each frame has the next free
 * block of the channel, so frame numbers run ahead of the clock in a burst of messages.
 */
public final class ChannelCapture {
    private static final int SHORT_MESSAGES = 3;
    private static final int SLOW_HEADER = 2;
    private static final byte[] NOTHING = {};

    private final AirCapture capture;
    private final AirChannel main;
    private final AirChannel slow;
    private final LinkLayer signalling = new LinkLayer(0, AirCapture.BLOCK);
    private final LinkLayer shortMessages;
    private final LinkLayer measurements = new LinkLayer(0, AirCapture.BLOCK - SLOW_HEADER);
    /** The frame after the last block: main and slow, downlink and uplink. */
    private final long[] free = new long[4];

    private CipherKey downlinkKey = CipherKey.NONE;
    private CipherKey uplinkKey = CipherKey.NONE;
    private int powerLevel;
    private int timingAdvance;
    private int blocks;

    ChannelCapture(AirCapture capture, ChannelNumber number) {
        this.capture = capture;
        main = AirChannel.main(number);
        slow = AirChannel.slow(number);
        boolean isSlow = number.kind().isSpeech();
        shortMessages = new LinkLayer(SHORT_MESSAGES, AirCapture.BLOCK - (isSlow ? SLOW_HEADER : 0));
    }

    /** The mobile, or the tower, ciphers from now on. */
    public void cipher(boolean isUplink, CipherKey key) {
        if (isUplink) {
            uplinkKey = key;
        } else {
            downlinkKey = key;
        }
    }

    /** A mobile establishes the main link. @param layer3 null for none */
    public void establish(OctetString layer3) {
        send(signalling.establish(true, layer3 == null ? NOTHING : layer3.toArray()), false);
    }

    /** A message; the first of short messages establishes their link. */
    public void message(boolean isUplink, int sapi, OctetString layer3) {
        if (sapi != SHORT_MESSAGES) {
            send(signalling.message(isUplink, layer3.toArray()), false);
            return;
        }
        boolean isSlow = main.bursts() > slow.bursts();
        if (!shortMessages.isEstablished()) {
            send(shortMessages.establish(isUplink, NOTHING), isSlow);
        }
        send(shortMessages.message(isUplink, layer3.toArray()), isSlow);
    }

    /** A message without acknowledgement. */
    public void unacknowledged(OctetString layer3) {
        send(signalling.unacknowledged(false, layer3.toArray()), false);
    }

    /** The mobile leaves the channel. */
    public void release() {
        send(signalling.release(), false);
    }

    /** A block of the slow associated channel in both directions. @param report the mobile's; empty if its block is lost */
    public void measured(int power, int advance, Optional<OctetString> report) {
        powerLevel = power;
        timingAdvance = advance;
        if (capture.isOn()) {
            byte[] information = capture.slowBlock(blocks++);
            if (information.length > 0) {
                send(measurements.system(information), true);
            }
            report.ifPresent(octets -> send(measurements.unacknowledged(true, octets.toArray()), true));
        }
    }

    private void send(List<LinkLayer.Frame> frames, boolean isSlow) {
        if (capture.isOn()) {
            frames.forEach(frame -> send(frame, isSlow));
        }
    }

    private void send(LinkLayer.Frame frame, boolean isSlow) {
        AirChannel channel = isSlow ? slow : main;
        boolean isUplink = frame.isUplink();
        int at = (isSlow ? 2 : 0) + (isUplink ? 1 : 0);
        long first = channel.next(Math.max(capture.frame(), free[at]), isUplink);
        free[at] = first + 1;
        OctetWriter block = new OctetWriter();
        if (isSlow) {
            block.octet(powerLevel).octet(timingAdvance);
        }
        byte[] octets = block.bytes(frame.octets()).toArray();
        CipherKey key = isUplink ? uplinkKey : downlinkKey;
        if (key.isCiphering()) {
            capture.send(channel, first, isUplink, octets, key);
        } else {
            capture.send(channel, first, isUplink, octets);
        }
    }
}
