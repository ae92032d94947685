package simgsm.air;

import java.time.OffsetDateTime;
import java.util.function.BiConsumer;
import simgsm.octets.Bounds;
import simgsm.octets.NetworkName;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Timestamp;

/**
 * A type of information element: its name and clause in the standard, and the codec of its value, without identifier
 * and length. Clauses 10.5.1, 10.5.3 and 10.5.4 are those of TS 24.008, 10.5.2 those of TS 44.018, 8.1 and 8.2 those
 * of TS 24.011.
 *
 * @param <V> the value in the record of a message
 */
public final class ElementType<V> {
    private interface ValueWriter<V> {
        void write(OctetWriter out, V value, Direction direction);
    }

    private interface ValueReader<V> {
        V read(MessageReader in, Direction direction) throws ProtocolViolation;
    }

    /** Reads a value with the same meaning in both directions. */
    private interface PlainReader<V> {
        V read(MessageReader in) throws ProtocolViolation;
    }

    public static final ElementType<Void> BEARER_CAPABILITY = unread("Bearer capability", "10.5.4.5");
    public static final ElementType<Void> CLASSMARK_1 = unread("Mobile station classmark 1", "10.5.1.5");
    public static final ElementType<Void> CLASSMARK_2 = unread("Mobile station classmark 2", "10.5.1.6");
    static final ElementType<Void> CLASSMARK_3 = unread("Mobile station classmark 3", "10.5.1.7");
    static final ElementType<Void> SPARE = unread("Spare half octet", "10.5.1.8");
    static final ElementType<Void> TIME_ZONE = unread("Time zone", "10.5.3.8");
    static final ElementType<OffsetDateTime> TIME = plain(
            "Time zone and time",
            "10.5.3.9",
            (out, time) -> out.string(Timestamp.ofUniversal(time).octets()),
            in -> new Timestamp(in.rest()).fromUniversal());
    static final ElementType<Void> MULTI_RATE = unread("MultiRate configuration", "10.5.2.21aa");
    static final ElementType<Void> FREQUENCY_LIST = unread("Frequency list", "10.5.2.13");

    static final ElementType<Cause> CAUSE = of(
            "Cause",
            "10.5.4.11",
            (out, cause, direction) -> writeCause(out, cause, CauseLocation.of(direction, false)),
            (in, direction) -> (Cause) readCause(in)[0]);
    /** The value is a {@link Cause} and its {@link CauseLocation}. */
    static final ElementType<Object[]> LOCATED_CAUSE = of(
            "Cause",
            "10.5.4.11",
            (out, values, direction) -> writeCause(out, (Cause) values[0], (CauseLocation) values[1]),
            (in, direction) -> readCause(in));

    static final ElementType<Integer> CALL_STATE = plain(
            "Call state", "10.5.4.6", (out, state) -> out.octet(0xc0 | state), in -> in.octet("call state") & 0x3f);
    static final ElementType<Character> KEYPAD_FACILITY =
            plain("Keypad facility", "10.5.4.17", (out, key) -> out.octet(key), ElementType::readKey);
    /** True if the network sends tones (value 8, in-band information); coding GSM, public network of the local user. */
    static final ElementType<Boolean> PROGRESS_INDICATOR = plain(
            "Progress indicator",
            "10.5.4.21",
            (out, isInBand) -> out.octet(0xe2).octet(0x88),
            in -> (in.twoOctets("progress indicator") & 0x7f) == 8);

    static final ElementType<CallControl.Signal> SIGNAL =
            coded("Signal", "10.5.4.23", 0xff, CallControl.Signal.values());
    static final ElementType<Msisdn> CONNECTED_NUMBER =
            plain("Connected number", "10.5.4.13", NumberElements::writeShown, NumberElements::read);
    static final ElementType<Msisdn> CALLING_NUMBER = CONNECTED_NUMBER.renamed("Calling party BCD number", "10.5.4.9");
    static final ElementType<Msisdn> CALLED_NUMBER =
            plain("Called party BCD number", "10.5.4.7", NumberElements::writeCalled, NumberElements::read);
    static final ElementType<Msisdn> REDIRECTING_NUMBER =
            CONNECTED_NUMBER.renamed("Redirecting party BCD number", "10.5.4.21b");
    /** Without a value: its presence is one. */
    static final ElementType<Boolean> CLIR_INVOCATION =
            plain("CLIR invocation", "10.5.4.11b", (out, isPresent) -> {}, in -> true);

    public static final ElementType<OctetString> FACILITY = octets("Facility", "10.5.4.15");
    static final ElementType<Integer> SS_VERSION = number("SS version indicator", "10.5.4.24", 0xff);

    static final ElementType<MobilityManagement.LocationUpdatingType> LOCATION_UPDATING_TYPE =
            coded("Location updating type", "10.5.3.5", 0x03, MobilityManagement.LocationUpdatingType.values());
    static final ElementType<MobilityManagement.ServiceType> SERVICE_TYPE =
            coded("CM service type", "10.5.3.3", 0x0f, MobilityManagement.ServiceType.values());
    static final ElementType<MobileIdentity.Type> IDENTITY_TYPE =
            coded("Identity type", "10.5.3.4", 0x07, MobileIdentity.Type.values());
    static final ElementType<Integer> KEY_SEQUENCE = number("Ciphering key sequence number", "10.5.1.2", 0x07);
    static final ElementType<LocationArea> LOCATION_AREA =
            plain("Location area identification", "10.5.1.3", IdentityElements::writeArea, IdentityElements::readArea);
    static final ElementType<MobileIdentity> MOBILE_IDENTITY =
            plain("Mobile identity", "10.5.1.4", IdentityElements::write, IdentityElements::read);
    static final ElementType<OctetString> RAND = octets("Authentication parameter RAND", "10.5.3.1");
    static final ElementType<OctetString> AUTN = octets("Authentication parameter AUTN", "10.5.3.1.1");
    static final ElementType<OctetString> SRES = octets("Authentication response parameter", "10.5.3.2");
    static final ElementType<OctetString> RES_EXTENSION =
            octets("Authentication response parameter (extension)", "10.5.3.2.1");
    static final ElementType<OctetString> AUTS = octets("Authentication failure parameter", "10.5.3.2.2");
    static final ElementType<RejectCause> REJECT_CAUSE = of(
            "Reject cause",
            "10.5.3.6",
            (out, cause, direction) -> out.octet(cause.code()),
            (in, direction) -> RejectCause.ofCode(in.octet("reject cause"), direction));
    static final ElementType<String> NETWORK_NAME = plain(
            "Network name",
            "10.5.3.5a",
            NetworkName::write,
            in -> NetworkName.read(in.octet("network name"), in.rest().toArray()));

    static final ElementType<Integer> RR_CAUSE = number("RR cause", "10.5.2.31", 0xff);
    static final ElementType<CipherAlgorithm> CIPHER_MODE_SETTING = plain(
            "Cipher mode setting",
            "10.5.2.9",
            (out, algorithm) -> out.octet(algorithm.setting()),
            in -> CipherAlgorithm.ofSetting(in.octet("cipher mode setting")));
    static final ElementType<Integer> CIPHER_RESPONSE = number("Cipher response", "10.5.2.10", 0x0f);
    static final ElementType<Integer> POWER_COMMAND = number("Power command", "10.5.2.28", 0x1f);
    static final ElementType<Integer> POWER_AND_ACCESS =
            POWER_COMMAND.renamed("Power command and access type", "10.5.2.28a");
    static final ElementType<Integer> CHANNEL_MODE = number("Channel mode", "10.5.2.6", 0xff);
    static final ElementType<Integer> HANDOVER_REFERENCE = number("Handover reference", "10.5.2.15", 0xff);
    static final ElementType<Integer> TIMING_ADVANCE = number("Timing advance", "10.5.2.40", 0x3f);
    static final ElementType<ChannelDescription> CHANNEL_DESCRIPTION = plain(
            "Channel description 2",
            "10.5.2.5a",
            (out, channel) -> out.string(channel.encode()),
            ChannelDescription::read);
    static final ElementType<RadioResource.CellDescription> CELL_DESCRIPTION = plain(
            "Cell description",
            "10.5.2.2",
            (out, cell) -> out.string(cell.encode()),
            RadioResource.CellDescription::read);
    static final ElementType<MeasurementResults> MEASUREMENT_RESULTS = plain(
            "Measurement results", "10.5.2.20", (out, results) -> out.bytes(results.value()), MeasurementResults::read);

    static final ElementType<Integer> CP_CAUSE = number("CP-Cause", "8.1.4.2", 0x7f);
    static final ElementType<RelayMessage> CP_USER_DATA =
            of("CP-User data", "8.1.4.1", RelayType::write, RelayType::read);
    static final ElementType<Integer> RP_REFERENCE = number("RP-Message reference", "8.2.3", 0xff);
    static final ElementType<Msisdn> RP_ORIGINATOR = CALLED_NUMBER.renamed("RP-Originator address", "8.2.5.1");
    static final ElementType<Msisdn> RP_DESTINATION = CALLED_NUMBER.renamed("RP-Destination address", "8.2.5.2");
    static final ElementType<OctetString> RP_USER_DATA = octets("RP-User data", "8.2.5.3");
    static final ElementType<RpCause> RP_CAUSE = plain(
            "RP-Cause",
            "8.2.5.4",
            (out, cause) -> out.octet(cause.code()),
            in -> RpCause.ofCode(in.octet("RP cause") & 0x7f));

    /** In the first octet of a cause: last octet of this part, coding standard defined for GSM. */
    private static final int GSM_CODING = 0xe0;

    private static final int LAST_OCTET = 0x80;

    private final String name;
    private final String clause;
    private final ValueWriter<V> writer;
    private final ValueReader<V> reader;

    private ElementType(String name, String clause, ValueWriter<V> writer, ValueReader<V> reader) {
        this.name = name;
        this.clause = clause;
        this.writer = writer;
        this.reader = reader;
    }

    private static <V> ElementType<V> of(String name, String clause, ValueWriter<V> writer, ValueReader<V> reader) {
        return new ElementType<>(name, clause, writer, reader);
    }

    private static <V> ElementType<V> plain(
            String name, String clause, BiConsumer<OctetWriter, V> writer, PlainReader<V> reader) {
        return of(
                name, clause, (out, value, direction) -> writer.accept(out, value), (in, direction) -> reader.read(in));
    }

    /** A type with values not held by any record. */
    private static ElementType<Void> unread(String name, String clause) {
        return of(name, clause, (out, value, direction) -> {}, (in, direction) -> null);
    }

    private static ElementType<OctetString> octets(String name, String clause) {
        return plain(name, clause, OctetWriter::string, MessageReader::rest);
    }

    /** A number in one octet. @param mask bits of a received one, and the greatest one sent */
    private static ElementType<Integer> number(String name, String clause, int mask) {
        return plain(
                name,
                clause,
                (out, value) -> out.octet(Bounds.check(name, value, 0, mask)),
                in -> in.octet(name) & mask);
    }

    private static <V extends Coded> ElementType<V> coded(String name, String clause, int mask, V[] values) {
        return plain(name, clause, (out, value) -> out.octet(value.code()), in -> {
            int code = in.octet(name) & mask;
            return Coded.find(values, code)
                    .orElseThrow(() -> ProtocolViolation.invalid(name + " " + code + " is not known here"));
        });
    }

    private ElementType<V> renamed(String otherName, String otherClause) {
        return of(otherName, otherClause, writer, reader);
    }

    /** The type's name in the standard. */
    public String title() {
        return name;
    }

    /** The clause that describes the value. */
    public String clause() {
        return clause;
    }

    void write(OctetWriter out, V value, Direction direction) {
        writer.write(out, value, direction);
    }

    V read(MessageReader in, Direction direction) throws ProtocolViolation {
        return reader.read(in, direction);
    }

    private static void writeCause(OctetWriter out, Cause cause, CauseLocation location) {
        out.octet(GSM_CODING | location.ordinal()).octet(LAST_OCTET | cause.code());
    }

    private static Object[] readCause(MessageReader in) throws ProtocolViolation {
        int coding = in.octet("cause");
        if ((coding & LAST_OCTET) == 0) {
            in.octet("cause's recommendation");
        }
        return new Object[] {Cause.ofCode(in.octet("cause value") & 0x7f), CauseLocation.ofCode(coding & 0x0f)};
    }

    private static char readKey(MessageReader in) throws ProtocolViolation {
        char key = (char) (in.octet("key") & 0x7f);
        if (!CallControl.isKey(key)) {
            throw ProtocolViolation.invalid("key " + (int) key + " is none of 0-9 * # A-D");
        }
        return key;
    }
}
