package simgsm.modem.at.sms;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.CmsError;
import simgsm.modem.at.state.ClientSettings;
import simgsm.octets.OctetString;
import simgsm.octets.Septets;
import simgsm.sms.Alphabet;
import simgsm.sms.DataCodingScheme;
import simgsm.sms.GsmAlphabet;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;

/** A message entered in text mode: its receiver, and the other fields by +CSMP. */
public final class TextSubmit {
    private static final int ISDN = 1;
    private static final int REJECT_DUPLICATES = 0x04;
    private static final int VALIDITY_RELATIVE = 0x10;
    private static final int STATUS_REPORT = 0x20;
    private static final int REPLY_PATH = 0x80;

    private final ClientSettings settings;
    private final SmsAddress receiver;

    private TextSubmit(ClientSettings settings, SmsAddress receiver) {
        this.settings = settings;
        this.receiver = receiver;
    }

    /** @param parameters number and type of address */
    public static TextSubmit to(ClientSettings settings, AtParameters parameters) throws AtException {
        return new TextSubmit(settings, address(settings, parameters, 0));
    }

    /** A stored message for another receiver. @param index of number and type */
    public static SubmitTpdu readdressed(ClientSettings settings, SubmitTpdu stored, AtParameters parameters, int index)
            throws AtException {
        return new SubmitTpdu(
                stored.rejectDuplicates(),
                stored.statusReportRequest(),
                stored.replyPath(),
                stored.reference(),
                address(settings, parameters, index),
                stored.protocolIdentifier(),
                stored.validity(),
                stored.userData());
    }

    public static OctetString octets(SubmitTpdu submit) {
        return TpduCodec.encode(submit);
    }

    private static SmsAddress address(ClientSettings settings, AtParameters parameters, int index) throws AtException {
        String number = settings.characterSet.decodeNumber(parameters.text(index));
        int type = parameters.number(index + 1, 128, 255, AddressType.of(number));
        String digits = number.startsWith("+") ? number.substring(1) : number;
        try {
            SmsAddress address = new SmsAddress(type >> 4 & 0x07, ISDN, digits);
            if (address.number().isEmpty()) {
                throw parameters.refused();
            }
            return address;
        } catch (IllegalArgumentException notANumber) {
            throw parameters.refused();
        }
    }

    /** The message with this text; its reference is set at submission. */
    public SubmitTpdu message(byte[] entered) throws AtException {
        int first = settings.submitFirstOctet;
        boolean hasValidity = (first & VALIDITY_RELATIVE) != 0;
        try {
            return new SubmitTpdu(
                    (first & REJECT_DUPLICATES) != 0,
                    (first & STATUS_REPORT) != 0,
                    (first & REPLY_PATH) != 0,
                    0,
                    receiver,
                    settings.submitProtocol,
                    hasValidity ? Optional.of(new ValidityPeriod.Relative(settings.submitValidity)) : Optional.empty(),
                    userData(new String(entered, StandardCharsets.ISO_8859_1)));
        } catch (IllegalArgumentException doesNotFit) {
            throw AtException.ofMessage(CmsError.INVALID_TEXT_PARAMETER);
        }
    }

    /**
     * The user data; IllegalArgumentException for a text that does not fit. For octets and, unless the character set
     * is UCS2, for UCS2 the entered text is hexadecimal (TS 27.005, 3.1, data). Text outside the GSM alphabet is sent
     * as UCS2.
     */
    private UserData userData(String entered) {
        DataCodingScheme coding = new DataCodingScheme(settings.submitCoding);
        if (coding.alphabet() == Alphabet.GSM_7BIT) {
            String text = settings.characterSet.decode(entered);
            if (!GsmAlphabet.encodes(text)) {
                return octets(DataCodingScheme.UCS2, text.getBytes(StandardCharsets.UTF_16BE));
            }
            byte[] codes = GsmAlphabet.encode(text);
            return new UserData(false, coding, codes.length, OctetString.of(Septets.pack(codes, 0)));
        }
        return octets(
                coding,
                OctetString.ofHex(entered.strip().toLowerCase(Locale.ROOT)).toArray());
    }

    private static UserData octets(DataCodingScheme coding, byte[] octets) {
        return new UserData(false, coding, octets.length, OctetString.of(octets));
    }
}
