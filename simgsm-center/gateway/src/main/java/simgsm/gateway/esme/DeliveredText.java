package simgsm.gateway.esme;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.smpp.Tlv;
import simgsm.sms.GsmAlphabet;

/**
 * The text of a deliver_sm, and its place among the parts of a long one (TS 23.040, 9.2.3.24.1 and 9.2.3.24.8).
 *
 * @param id equal whenever the SMSC sends the same part again, and in no other: its reference and a digest
 * @param group equal in the parts of one text
 * @param part from 1
 */
record DeliveredText(String id, String group, int parts, int part, String text) {
    private static final int ID_OCTETS = 8;

    /** @throws SmppViolation if the content is no text */
    static DeliveredText of(SmppMessage message) throws SmppViolation {
        byte[] octets = message.content().toArray();
        String source = message.source().value() + ">" + message.destination().value();
        String reference = message.parameter(Tlv.USER_MESSAGE_REFERENCE)
                .map(value -> HexFormat.of().formatHex(value.toArray()))
                .orElse("");
        int length = message.hasHeader() && octets.length > 0 ? Math.min(octets.length, (octets[0] & 0xff) + 1) : 0;
        byte[] header = Arrays.copyOf(octets, length);
        String text = text(message.dataCoding(), Arrays.copyOfRange(octets, length, octets.length));
        String id = reference + "." + digest(source + "\0" + HexFormat.of().formatHex(octets));
        for (int at = 1; at + 1 < length; at += 2 + (header[at + 1] & 0xff)) {
            int size = header[at + 1] & 0xff;
            boolean isPlace = header[at] == 0 && size == 3 || header[at] == 8 && size == 4;
            if (isPlace && at + 2 + size <= length) {
                int parts = header[at + size] & 0xff;
                int part = header[at + size + 1] & 0xff;
                String group = HexFormat.of().formatHex(header, at, at + size + 1);
                if (part >= 1 && part <= parts) {
                    return new DeliveredText(id, source + "/" + group, parts, part, text);
                }
            }
        }
        return new DeliveredText(id, id, 1, 1, text);
    }

    private static String text(int dataCoding, byte[] octets) throws SmppViolation {
        return switch (dataCoding) {
            case 0 -> GsmAlphabet.decode(octets);
            case 1, 3 -> new String(octets, StandardCharsets.ISO_8859_1);
            case 8 -> new String(octets, StandardCharsets.UTF_16BE);
            default -> throw new SmppViolation(SmppStatus.INVALID_DATA_CODING, "no text: data_coding " + dataCoding);
        };
    }

    private static String digest(String text) {
        try {
            byte[] all = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(all, 0, ID_OCTETS);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e); // each Java has SHA-256
        }
    }
}
