package simgsm.center.smpp;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simgsm.center.smpp.EsmeSettings.EsmeAlphabet;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Octets;
import simgsm.octets.Septets;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.smpp.Tlv;
import simgsm.sms.Alphabet;
import simgsm.sms.DataCodingScheme;
import simgsm.sms.GsmAlphabet;
import simgsm.sms.UserData;

/**
 * Converts the content of SMPP messages to the user data of mobiles and back. SMPP has unpacked septets, one per octet, and
 * further data codings.
 */
final class MessageContent {
    private static final int DEFAULT_ALPHABET = 0;
    private static final int ASCII = 1;
    private static final int OCTETS = 2;
    private static final int LATIN_1 = 3;
    private static final int MORE_OCTETS = 4;
    private static final int UCS2 = 8;
    /** First data coding scheme of TS 23.038 (5.2.19). */
    private static final int FIRST_OF_MOBILES = 0x10;

    private static final int ESCAPE = 0x1b;
    private static final int MAX_PARTS = 255;

    /** @param dataCoding of SMPP */
    record Translated(int dataCoding, boolean hasHeader, OctetString octets) {}

    private MessageContent() {}

    /**
     * The parts for a mobile; more than one only for a message without a header.
     *
     * @param dataCoding of the text, see {@link #standardCoding}
     * @param reference of the concatenated parts, 0 to 255
     */
    static List<UserData> parts(SmppMessage message, int dataCoding, int reference) throws SmppViolation {
        byte[] octets = message.content().toArray();
        String charset = charset(dataCoding);
        if (!charset.isEmpty() && Charset.isSupported(charset)) {
            return partsOfText(message, octets, Charset.forName(charset), reference);
        }
        DataCodingScheme scheme = scheme(dataCoding);
        byte[] header = message.hasHeader() ? header(octets) : sarHeader(message);
        byte[] text = message.hasHeader() ? Octets.range(octets, header.length, octets.length) : octets;
        return parts(header, text, scheme, reference);
    }

    /** The standard data_coding for the application's meaning of this one. */
    static int standardCoding(int dataCoding, Optional<EsmeAlphabet> own) {
        if (own.isEmpty() || dataCoding != DEFAULT_ALPHABET && dataCoding != ASCII) {
            return dataCoding;
        }
        return switch (own.get()) {
            case GSM -> DEFAULT_ALPHABET;
            case LATIN1 -> LATIN_1;
            case ASCII -> ASCII;
        };
    }

    private static List<UserData> partsOfText(SmppMessage message, byte[] octets, Charset charset, int reference)
            throws SmppViolation {
        byte[] header = message.hasHeader() ? header(octets) : sarHeader(message);
        int from = message.hasHeader() ? header.length : 0;
        String text;
        try {
            text = charset.newDecoder()
                    .decode(ByteBuffer.wrap(octets, from, octets.length - from))
                    .toString();
        } catch (CharacterCodingException e) {
            throw new SmppViolation(SmppStatus.SUBMIT_FAILED, "octets that " + charset + " does not have");
        }
        boolean isPlain = GsmAlphabet.encodes(text);
        byte[] coded = isPlain ? GsmAlphabet.encode(text) : text.getBytes(StandardCharsets.UTF_16BE);
        return parts(header, coded, isPlain ? DataCodingScheme.GSM_7BIT : DataCodingScheme.UCS2, reference);
    }

    /** The name of an alphabet unknown to mobiles; some run-time images lack those of JIS and KS C 5601. */
    private static String charset(int dataCoding) {
        return switch (dataCoding) {
            case ASCII, LATIN_1 -> "ISO-8859-1";
            case 5 -> "x-JIS0208";
            case 6 -> "ISO-8859-5";
            case 7 -> "ISO-8859-8";
            case 13 -> "JIS_X0212-1990";
            case 14 -> "EUC-KR";
            default -> "";
        };
    }

    private static DataCodingScheme scheme(int dataCoding) throws SmppViolation {
        return switch (dataCoding) {
            case DEFAULT_ALPHABET -> DataCodingScheme.GSM_7BIT;
            case OCTETS, MORE_OCTETS -> DataCodingScheme.OCTETS;
            case UCS2 -> DataCodingScheme.UCS2;
            default -> {
                if (dataCoding < FIRST_OF_MOBILES) {
                    throw new SmppViolation(
                            SmppStatus.INVALID_DATA_CODING, "data_coding " + dataCoding + " has no known alphabet");
                }
                yield new DataCodingScheme(dataCoding);
            }
        };
    }

    private static byte[] header(byte[] octets) throws SmppViolation {
        int length = octets.length == 0 ? 0 : (octets[0] & 0xff) + 1;
        if (length == 0 || length > octets.length) {
            throw new SmppViolation(SmppStatus.INVALID_MESSAGE_LENGTH, "a header longer than the message");
        }
        return Arrays.copyOf(octets, length);
    }

    /** The header of a part with sar_ parameters (5.3.2.22 to 24); else empty. */
    private static byte[] sarHeader(SmppMessage message) {
        if (message.parameters().size() < 3) {
            return new byte[0];
        }
        int reference = number(message.parameter(Tlv.SAR_REFERENCE));
        int total = number(message.parameter(Tlv.SAR_TOTAL));
        int part = number(message.parameter(Tlv.SAR_PART));
        boolean makesSense = reference >= 0 && part >= 1 && part <= total && total <= MAX_PARTS;
        return makesSense
                ? new byte[] {6, 8, 4, (byte) (reference >> 8), (byte) reference, (byte) total, (byte) part}
                : new byte[0];
    }

    private static int number(Optional<OctetString> value) {
        if (value.isEmpty() || value.get().length() > 2) {
            return -1;
        }
        int number = 0;
        for (byte octet : value.get().toArray()) {
            number = number << 8 | octet & 0xff;
        }
        return number;
    }

    private static List<UserData> parts(byte[] header, byte[] text, DataCodingScheme scheme, int reference)
            throws SmppViolation {
        Alphabet alphabet = scheme.alphabet();
        check(alphabet, text);
        if (units(header, text, alphabet) <= alphabet.unitsInOnePart() * octetsInUnit(alphabet)) {
            return List.of(part(header, text, scheme));
        }
        if (header.length > 0) {
            throw new SmppViolation(SmppStatus.INVALID_MESSAGE_LENGTH, "header and text are too long for one part");
        }
        List<byte[]> pieces = pieces(text, alphabet);
        if (pieces.size() > MAX_PARTS) {
            throw new SmppViolation(SmppStatus.INVALID_MESSAGE_LENGTH, "the text needs " + pieces.size() + " parts");
        }
        List<UserData> parts = new ArrayList<>(pieces.size());
        for (byte[] piece : pieces) {
            byte[] place = {5, 0, 3, (byte) reference, (byte) pieces.size(), (byte) (parts.size() + 1)};
            parts.add(part(place, piece, scheme));
        }
        return parts;
    }

    private static void check(Alphabet alphabet, byte[] text) throws SmppViolation {
        if (alphabet == Alphabet.UCS2 && text.length % 2 != 0) {
            throw new SmppViolation(
                    SmppStatus.INVALID_MESSAGE_LENGTH, "UCS-2 of " + text.length + " octets, an odd number");
        }
        if (alphabet == Alphabet.GSM_7BIT) {
            for (byte octet : text) {
                if (octet < 0) {
                    throw new SmppViolation(
                            SmppStatus.SUBMIT_FAILED, "octets above 0x7f in text of 7 bits; data_coding 3 is Latin-1");
                }
            }
        }
    }

    /** The length in septets or octets. */
    private static int units(byte[] header, byte[] text, Alphabet alphabet) {
        return alphabet == Alphabet.GSM_7BIT ? headerSeptets(header.length) + text.length : header.length + text.length;
    }

    private static int octetsInUnit(Alphabet alphabet) {
        return alphabet == Alphabet.UCS2 ? 2 : 1;
    }

    private static int headerSeptets(int octets) {
        return (octets * 8 + 6) / 7;
    }

    private static UserData part(byte[] header, byte[] text, DataCodingScheme scheme) {
        OctetWriter out = new OctetWriter().bytes(header);
        if (scheme.alphabet() != Alphabet.GSM_7BIT) {
            OctetString octets = OctetString.of(out.bytes(text).toArray());
            return new UserData(header.length > 0, scheme, octets.length(), octets);
        }
        int headerSeptets = headerSeptets(header.length);
        out.bytes(Septets.pack(text, headerSeptets * 7 - header.length * 8));
        return new UserData(header.length > 0, scheme, headerSeptets + text.length, OctetString.of(out.toArray()));
    }

    /** Splits a text, but not between an escape and its code or inside a surrogate pair. */
    private static List<byte[]> pieces(byte[] text, Alphabet alphabet) {
        int most = alphabet.unitsInEachOfMany() * octetsInUnit(alphabet);
        List<byte[]> pieces = new ArrayList<>();
        for (int from = 0; from < text.length; ) {
            int to = Math.min(text.length, from + most);
            if (to < text.length && alphabet == Alphabet.GSM_7BIT && text[to - 1] == ESCAPE) {
                to--;
            } else if (to < text.length && alphabet == Alphabet.UCS2 && (text[to - 2] & 0xfc) == 0xd8) {
                to -= 2;
            }
            pieces.add(Octets.range(text, from, to));
            from = to;
        }
        return pieces;
    }

    /**
     * The content for an application.
     *
     * @param submittedAs the data_coding of the sending application, by the standard; -1 for a mobile
     * @param own the receiving application's alphabet, if any
     */
    static Translated translate(UserData part, int submittedAs, Optional<EsmeAlphabet> own) {
        DataCodingScheme scheme = part.coding();
        byte[] octets = part.octets().toArray();
        int header = part.hasHeader() ? (octets[0] & 0xff) + 1 : 0;
        boolean isPlain = scheme.octet() < FIRST_OF_MOBILES;
        boolean isGsm = scheme.alphabet() == Alphabet.GSM_7BIT;
        boolean isText = isGsm || scheme.alphabet() == Alphabet.UCS2;
        if (own.isPresent() && isText && isPlain && submittedAs != LATIN_1 && (isGsm || submittedAs == ASCII)) {
            Optional<byte[]> text = encode(part.text(), own.get());
            byte[] coded = text.orElseGet(() -> part.text().getBytes(StandardCharsets.UTF_16BE));
            int dataCoding = text.isPresent() ? DEFAULT_ALPHABET : UCS2;
            return new Translated(dataCoding, header > 0, joined(octets, header, coded, 0));
        }
        if (isText && (submittedAs == LATIN_1 || submittedAs == ASCII)) {
            byte[] text = part.text().getBytes(StandardCharsets.ISO_8859_1);
            return new Translated(submittedAs, header > 0, joined(octets, header, text, 0));
        }
        if (isGsm) {
            byte[] septets = Septets.unpack(octets, part.length(), 0);
            int dataCoding = isPlain ? DEFAULT_ALPHABET : scheme.octet();
            return new Translated(dataCoding, header > 0, joined(octets, header, septets, headerSeptets(header)));
        }
        int dataCoding = !isPlain ? scheme.octet() : scheme.alphabet() == Alphabet.UCS2 ? UCS2 : MORE_OCTETS;
        return new Translated(submittedAs == OCTETS ? OCTETS : dataCoding, header > 0, part.octets());
    }

    /**
     * A text in an application's alphabet, one octet per character or septet; empty if the alphabet lacks a character.
     */
    static Optional<byte[]> encode(String text, EsmeAlphabet alphabet) {
        Charset charset = alphabet == EsmeAlphabet.ASCII ? StandardCharsets.US_ASCII : StandardCharsets.ISO_8859_1;
        boolean isPossible = alphabet == EsmeAlphabet.GSM
                ? GsmAlphabet.encodes(text)
                : charset.newEncoder().canEncode(text);
        return !isPossible
                ? Optional.empty()
                : Optional.of(alphabet == EsmeAlphabet.GSM ? GsmAlphabet.encode(text) : text.getBytes(charset));
    }

    private static OctetString joined(byte[] header, int headerLength, byte[] text, int from) {
        byte[] all = Arrays.copyOf(header, headerLength + Math.max(0, text.length - from));
        System.arraycopy(text, Math.min(from, text.length), all, headerLength, all.length - headerLength);
        return OctetString.of(all);
    }
}
