package simgsm.cells.capture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simgsm.octets.OctetWriter;
import simgsm.octets.Octets;

/**
 * The frames of one link of the link layer, LAPDm (TS 44.006), as they pass between tower and mobile. A frame is acknowledged
 * by the other side's next message, or by RR before the next message of the same side.
 */
final class LinkLayer {
    /** A frame. @param octets 23, or 21 on a slow associated channel */
    record Frame(boolean isUplink, byte[] octets) {}

    private static final int FILL = 0x2b;
    private static final int HEADER = 3;
    private static final int POLL = 0x10;
    private static final int SABM = 0x2f;
    private static final int UA = 0x63;
    private static final int DISC = 0x43;
    private static final int UI = 0x03;
    private static final int RR = 0x01;
    private static final int MODULUS = 8;
    private static final int UP = 1;

    private final int sapi;
    private final int length;
    /** V(S) of the downlink and the uplink: messages sent. */
    private final int[] sent = new int[2];
    /** Messages of each side that the other has acknowledged. */
    private final int[] acknowledged = new int[2];

    private boolean isEstablished;
    private final List<Frame> frames = new ArrayList<>();

    /** @param length octets of a frame */
    LinkLayer(int sapi, int length) {
        this.sapi = sapi;
        this.length = length;
    }

    boolean isEstablished() {
        return isEstablished;
    }

    /** SABM and its answer. @param layer3 of contention resolution, which the tower repeats; may be empty */
    List<Frame> establish(boolean isUplink, byte[] layer3) {
        isEstablished = true;
        Arrays.fill(sent, 0);
        Arrays.fill(acknowledged, 0);
        add(isUplink, true, SABM | POLL, layer3, false);
        add(!isUplink, false, UA | POLL, layer3, false);
        return taken();
    }

    /** A message in as many frames as it needs. */
    List<Frame> message(boolean isUplink, byte[] layer3) {
        int from = isUplink ? UP : 0;
        int most = length - HEADER;
        for (int at = 0; at < layer3.length; at += most) {
            if (sent[from] != acknowledged[from]) {
                acknowledged[from] = sent[from];
                add(!isUplink, false, RR | sent[from] << 5, new byte[0], false);
            }
            int end = Math.min(layer3.length, at + most);
            acknowledged[1 - from] = sent[1 - from];
            add(
                    isUplink,
                    true,
                    sent[1 - from] << 5 | sent[from] << 1,
                    Octets.range(layer3, at, end),
                    end < layer3.length);
            sent[from] = (sent[from] + 1) % MODULUS;
        }
        return taken();
    }

    /** A message without acknowledgement. */
    List<Frame> unacknowledged(boolean isUplink, byte[] layer3) {
        add(isUplink, true, UI, layer3, false);
        return taken();
    }

    /** System information, which begins with its length. */
    List<Frame> system(byte[] block) {
        addFilled(false, new OctetWriter().octet(sapi << 2 | 3).octet(UI).bytes(block));
        return taken();
    }

    /** DISC and its answer. */
    List<Frame> release() {
        if (isEstablished) {
            isEstablished = false;
            add(true, true, DISC | POLL, new byte[0], false);
            add(false, false, UA | POLL, new byte[0], false);
        }
        return taken();
    }

    private void add(boolean isUplink, boolean isCommand, int control, byte[] information, boolean hasMore) {
        boolean commandBit = isCommand != isUplink;
        addFilled(
                isUplink,
                new OctetWriter()
                        .octet(sapi << 2 | (commandBit ? 2 : 0) | 1)
                        .octet(control)
                        .octet(information.length << 2 | (hasMore ? 2 : 0) | 1)
                        .bytes(information));
    }

    private void addFilled(boolean isUplink, OctetWriter out) {
        while (out.length() < length) {
            out.octet(FILL);
        }
        frames.add(new Frame(isUplink, out.toArray()));
    }

    private List<Frame> taken() {
        List<Frame> all = List.copyOf(frames);
        frames.clear();
        return all;
    }
}
