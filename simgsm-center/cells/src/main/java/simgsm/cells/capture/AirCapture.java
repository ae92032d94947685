package simgsm.cells.capture;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import simgsm.air.ChannelNumber;
import simgsm.air.IdentityElements;
import simgsm.air.Layer3Header;
import simgsm.air.MobileIdentity;
import simgsm.cells.cipher.CipherKey;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The capture of one tower's carrier: common channels, and a {@link ChannelCapture} for each dedicated one. Fill frames, cell
 * broadcast and speech are left out.
 */
public final class AirCapture {
    static final int BLOCK = 23;
    /** Octets 2 and 3 of system information: types in the order of 8 multiframes (TS 45.002, 6.3.1.3). */
    private static final int[] BROADCAST_ORDER = {0x19, 0x1a, 0x1b, 0x1c, 0x02, 0x03, 0x1b, 0x1c};

    private static final int TYPE_2 = 0x1a;
    private static final int MULTIFRAME = 51;
    private static final int FILL = 0x2b;
    private static final int PAGING_REQUEST_1 = 0x21;
    private static final int UPLINK = 0x4000;
    private static final int NORMAL_BURST = 6;
    private static final long HYPERFRAME = 2_715_648;

    private final int arfcn;
    private final int trainingSequence;
    private final LongSupplier frame;
    private final Consumer<byte[]> receiver;
    private final Map<Integer, OctetString> broadcast = new TreeMap<>();
    private final Map<Integer, OctetString> slow = new TreeMap<>();
    private long granted;

    /**
     * A capture.
     *
     * @param frame the number of the present frame
     * @param receiver takes GSMTAP packets; null for no capture
     */
    public AirCapture(int arfcn, int bsic, LongSupplier frame, Consumer<byte[]> receiver) {
        this.arfcn = arfcn;
        this.trainingSequence = bsic & 0x07;
        this.frame = frame;
        this.receiver = receiver;
    }

    public boolean isOn() {
        return receiver != null;
    }

    long frame() {
        return frame.getAsLong();
    }

    /** System information of the broadcast channel. */
    public void broadcast(OctetString block) {
        keep(broadcast, block);
    }

    /** System information of the slow associated channels. */
    public void slow(OctetString block) {
        keep(slow, block);
    }

    private static void keep(Map<Integer, OctetString> blocks, OctetString block) {
        if (block.length() > 2 && block.length() <= BLOCK) {
            blocks.put(block.octet(2), block);
        }
    }

    /** The system information that a mobile on a dedicated channel receives in turn; empty for none. */
    byte[] slowBlock(long count) {
        return slow.isEmpty()
                ? new byte[0]
                : slow.values().stream()
                        .skip(count % slow.size())
                        .findFirst()
                        .orElseThrow()
                        .toArray();
    }

    /** Sends the block of the broadcast channel in the current multiframe. */
    public void multiframe() {
        int type = BROADCAST_ORDER[(int) (frame() / MULTIFRAME % BROADCAST_ORDER.length)];
        OctetString block = broadcast.getOrDefault(type, broadcast.get(TYPE_2));
        if (block != null) {
            send(AirChannel.common(AirChannel.BCCH, 2), frame() / MULTIFRAME * MULTIFRAME + 2, false, block.toArray());
        }
    }

    /** An access burst of a mobile. */
    public void access(int octet) {
        send(AirChannel.common(AirChannel.RACH, 0), frame(), true, new byte[] {(byte) octet});
    }

    /** A block of the access grant channel. */
    public void grant(OctetString block) {
        AirChannel channel = AirChannel.common(AirChannel.AGCH, AirChannel.commonStart(0));
        granted = channel.next(Math.max(frame(), granted + 1), false);
        send(channel, granted, false, filled(new OctetWriter().string(block)));
    }

    /** PAGING REQUEST TYPE 1 in the block that has just ended. @param block of the paging blocks */
    public void page(int block, MobileIdentity identity) {
        if (!isOn()) {
            return;
        }
        OctetWriter value = new OctetWriter();
        IdentityElements.write(value, identity);
        OctetWriter out = new OctetWriter()
                .octet(4 + value.length() << 2 | 1)
                .octet(Layer3Header.RADIO_RESOURCE)
                .octet(PAGING_REQUEST_1)
                .octet(0)
                .octet(value.length())
                .bytes(value.toArray());
        AirChannel channel = AirChannel.common(AirChannel.PCH, AirChannel.commonStart(block));
        send(channel, channel.next(frame() - MULTIFRAME, false), false, filled(out));
    }

    private static byte[] filled(OctetWriter out) {
        while (out.length() < BLOCK) {
            out.octet(FILL);
        }
        return out.toArray();
    }

    /** The capture of a dedicated channel. */
    public ChannelCapture channel(ChannelNumber number) {
        return new ChannelCapture(this, number);
    }

    /** Sends a block as it is. @param first frame of its first burst */
    void send(AirChannel channel, long first, boolean isUplink, byte[] block) {
        if (isOn()) {
            receiver.accept(packet(1, channel, channel.type(), first, isUplink, block));
        }
    }

    /** Sends a block as ciphered bursts. */
    void send(AirChannel channel, long first, boolean isUplink, byte[] block, CipherKey key) {
        long[] frames = BurstCoder.frames(first, channel.step(), channel.bursts());
        int at = 0;
        for (byte[] burst : BurstCoder.bursts(block, frames, trainingSequence, key, isUplink)) {
            receiver.accept(packet(3, channel, NORMAL_BURST, frames[at++], isUplink, burst));
        }
    }

    /** GSMTAP version 2: type 1 for a block of the air interface, 3 for a burst. */
    private byte[] packet(int type, AirChannel channel, int subtype, long at, boolean isUplink, byte[] payload) {
        return new OctetWriter()
                .octet(2)
                .octet(4)
                .octet(type)
                .octet(channel.timeslot())
                .twoOctets(arfcn | (isUplink ? UPLINK : 0))
                .twoOctets(0)
                .fourOctets((int) (at % HYPERFRAME))
                .octet(subtype)
                .octet(0)
                .octet(channel.subslot())
                .octet(0)
                .bytes(payload)
                .toArray();
    }
}
