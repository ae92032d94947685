package simgsm.rr;

import java.util.Optional;
import simgsm.air.Layer3Header;
import simgsm.air.LocationArea;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetWriter;
import simgsm.rr.SystemInformation.ControlChannel;
import simgsm.rr.SystemInformation.Neighbours;
import simgsm.rr.SystemInformation.RandomAccess;
import simgsm.rr.SystemInformation.Reselection;
import simgsm.rr.SystemInformation.SelectionParameters;
import simgsm.rr.SystemInformation.Type3;
import simgsm.rr.SystemInformation.Type6;

/** Encodes and decodes system information. */
final class SystemInformationCodec {
    private static final int TYPE_3 = 0x1b;
    private static final int TYPE_6 = 0x1e;
    private static final int FREQUENCY_OCTETS = 16;
    private static final int BCCH_OCTETS = 23;
    private static final int SACCH_OCTETS = 19;
    private static final int FILL = 0x2b;
    private static final int[] ATTEMPTS = {1, 2, 4, 7};
    private static final int[] SPREAD = {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 20, 25, 32, 50};
    private static final int HYSTERESIS_STEP_DECIBELS = 2;
    private static final int TEMPORARY_STEP_DECIBELS = 10;
    private static final int LARGEST_TEMPORARY = 7;
    private static final int PENALTY_STEP_SECONDS = 20;
    private static final int FOR_GOOD = 31;
    /** Combination of common channels: one physical channel with SDCCH/4. */
    private static final int COMBINED = 1;

    private SystemInformationCodec() {}

    static void write(OctetWriter out, SystemInformation information) {
        if (information instanceof Neighbours neighbours) {
            begin(out, neighbours.list().pseudoLength(), neighbours.list().messageType())
                    .string(FrequencyList.encode(neighbours.arfcns()));
        } else if (information instanceof Type3 type) {
            begin(out, 18, TYPE_3).twoOctets(type.cellIdentity());
            writeArea(out, type.area());
            writeControl(out, type.control());
            out.octet(timeoutCode(type.radioLinkTimeout()));
            SelectionParameters selection = type.selection();
            out.octet(selection.hysteresisDecibels() / HYSTERESIS_STEP_DECIBELS << 5 | selection.powerLevel())
                    .octet(selection.accessMin());
            writeAccess(out, type.access());
            type.reselection().ifPresent(reselection -> writeReselection(out, reselection));
            fill(out, BCCH_OCTETS);
        } else if (information instanceof Type6 type) {
            begin(out, 11, TYPE_6).twoOctets(type.cellIdentity());
            writeArea(out, type.area());
            out.octet(timeoutCode(type.radioLinkTimeout())).octet(0xff);
            fill(out, SACCH_OCTETS);
        }
    }

    private static OctetWriter begin(OctetWriter out, int octets, int type) {
        return out.octet(octets << 2 | 1).octet(Layer3Header.RADIO_RESOURCE).octet(type);
    }

    private static void fill(OctetWriter out, int octets) {
        while (out.length() < octets) {
            out.octet(FILL);
        }
    }

    private static int timeoutCode(int timeout) {
        return timeout / 4 - 1;
    }

    private static void writeArea(OctetWriter out, LocationArea area) {
        String country = area.countryCode();
        String network = area.networkCode();
        out.octet(digit(country, 1) << 4 | digit(country, 0))
                .octet((network.length() > 2 ? digit(network, 2) : 0x0f) << 4 | digit(country, 2))
                .octet(digit(network, 1) << 4 | digit(network, 0))
                .twoOctets(area.areaCode());
    }

    private static int digit(String digits, int place) {
        return digits.charAt(place) - '0';
    }

    private static void writeControl(OctetWriter out, ControlChannel control) {
        out.octet((control.isAttachNeeded() ? 0x40 : 0)
                        | control.blocksForAccessGrant() << 3
                        | (control.isCombined() ? COMBINED : 0))
                .octet(control.pagingMultiframes() - 2)
                .octet(control.t3212());
    }

    private static void writeAccess(OctetWriter out, RandomAccess access) {
        out.octet(indexOf(ATTEMPTS, access.attempts()) << 6
                        | indexOf(SPREAD, access.spreadSlots()) << 2
                        | (access.isBarred() ? 2 : 0))
                .twoOctets(0);
    }

    private static int indexOf(int[] values, int value) {
        for (int i = 0; i < values.length; i++) {
            if (values[i] == value) {
                return i;
            }
        }
        throw new IllegalArgumentException("RACH control: no code for " + value);
    }

    /** SI 3 rest octets (10.5.2.34), then fill octets; each bit is sent relative to the fill pattern 2B. */
    private static void writeReselection(OctetWriter out, Reselection reselection) {
        int temporary = Double.isInfinite(reselection.temporaryOffsetDecibels())
                ? LARGEST_TEMPORARY
                : (int) reselection.temporaryOffsetDecibels() / TEMPORARY_STEP_DECIBELS;
        int penalty =
                reselection.penaltySeconds() < 0 ? FOR_GOOD : reselection.penaltySeconds() / PENALTY_STEP_SECONDS - 1;
        int bits = reselection.offsetDecibels() / HYSTERESIS_STEP_DECIBELS << 8 | temporary << 5 | penalty;
        // H, then CBQ 0, 14 bits of values.
        out.twoOctets(0x8000 | bits);
    }

    static Optional<SystemInformation> read(MessageReader in) throws ProtocolViolation {
        if (in.hasMore() && (in.peek() & 0x0f) != Layer3Header.RADIO_RESOURCE) {
            in.octet("L2 pseudo length");
        }
        in.octet("protocol discriminator");
        int type = in.octet("system information type");
        return switch (type) {
            case TYPE_3 -> Optional.of(readType3(in));
            case TYPE_6 -> Optional.of(new Type6(in.twoOctets("cell identity"), readArea(in), readTimeout(in)));
            default -> readNeighbours(type, in);
        };
    }

    private static Optional<SystemInformation> readNeighbours(int type, MessageReader in) throws ProtocolViolation {
        for (NeighbourList list : NeighbourList.values()) {
            if (list.messageType() == type) {
                var arfcns = FrequencyList.decode(in.string(FREQUENCY_OCTETS, "neighbour cells"));
                return Optional.of(new Neighbours(list, arfcns));
            }
        }
        return Optional.empty();
    }

    private static Type3 readType3(MessageReader in) throws ProtocolViolation {
        int cell = in.twoOctets("cell identity");
        LocationArea area = readArea(in);
        int first = in.octet("control channel description");
        int second = in.octet("control channel description");
        ControlChannel control = new ControlChannel(
                (first & 0x40) != 0, first >> 3 & 7, (first & 7) == COMBINED, (second & 7) + 2, in.octet("T3212"));
        if (control.pagingBlocks() < 1) {
            throw ProtocolViolation.invalid("a control channel description without a block for paging");
        }
        int timeout = readTimeout(in);
        int power = in.octet("cell selection");
        int access = in.octet("cell selection");
        SelectionParameters selection =
                new SelectionParameters((power >> 5) * HYSTERESIS_STEP_DECIBELS, power & 0x1f, access & 0x3f);
        return new Type3(cell, area, control, timeout, selection, readAccess(in), readReselection(in));
    }

    private static LocationArea readArea(MessageReader in) throws ProtocolViolation {
        int first = in.octet("country code");
        int second = in.octet("country code");
        int third = in.octet("network code");
        String country = text(first) + text(first >> 4) + text(second);
        String network = text(third) + text(third >> 4) + (second >> 4 == 0x0f ? "" : text(second >> 4));
        if (!(country + network).matches("[0-9]+")) {
            throw ProtocolViolation.invalid("location area of " + country + "/" + network);
        }
        return new LocationArea(country, network, in.twoOctets("location area code"));
    }

    private static String text(int digit) {
        return Integer.toHexString(digit & 0x0f);
    }

    private static int readTimeout(MessageReader in) throws ProtocolViolation {
        return ((in.octet("cell options") & 0x0f) + 1) * 4;
    }

    private static RandomAccess readAccess(MessageReader in) throws ProtocolViolation {
        int first = in.octet("RACH control");
        in.twoOctets("RACH control");
        return new RandomAccess(ATTEMPTS[first >> 6], SPREAD[first >> 2 & 0x0f], (first & 2) != 0);
    }

    private static Optional<Reselection> readReselection(MessageReader in) throws ProtocolViolation {
        if (in.remaining() < 2) {
            return Optional.empty();
        }
        int bits = in.twoOctets("rest octets");
        // The fill pattern's first bit is L; H means that the parameters follow.
        if ((bits & 0x8000) == 0) {
            return Optional.empty();
        }
        int temporary = bits >> 5 & 7;
        int penalty = bits & 0x1f;
        return Optional.of(new Reselection(
                (bits >> 8 & 0x3f) * HYSTERESIS_STEP_DECIBELS,
                temporary == LARGEST_TEMPORARY ? Double.POSITIVE_INFINITY : temporary * TEMPORARY_STEP_DECIBELS,
                penalty == FOR_GOOD ? -1 : (penalty + 1) * PENALTY_STEP_SECONDS));
    }
}
