package simgsm.modem.at.sms;

import java.util.Locale;
import simgsm.air.Direction;
import simgsm.air.MessageReader;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.SemiOctets;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtException;
import simgsm.modem.at.CmsError;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;

/**
 * A message in PDU mode: the service centre's address, then the transfer unit, as hexadecimal digits (TS 27.005,
 * 3.1).
 *
 * @param serviceCenter as written, or the modem's
 */
public record PduText(Msisdn serviceCenter, OctetString tpdu) {
    private static final int TYPE_MASK = 0x03;
    private static final int SUBMIT = 0x01;
    private static final int COMMAND = 0x02;

    /** TP-MR, first and second octet of the sent units; TP-PID and TP-CT, TP-MN of a COMMAND before its address. */
    private static final int COMMAND_ADDRESS = 5;

    /**
     * Reads a client's input.
     *
     * @param length octets of the transfer unit, as announced in the command
     * @throws AtException with 304 for digits that are no message
     */
    public static PduText parse(byte[] entered, int length, Msisdn ownServiceCenter) throws AtException {
        StringBuilder digits = new StringBuilder();
        for (byte character : entered) {
            if (character > ' ') {
                digits.append((char) character);
            }
        }
        try {
            MessageReader in = new MessageReader(OctetString.ofHex(digits.toString()));
            MessageReader address = in.lengthAndValue("service centre");
            Msisdn center = ownServiceCenter;
            if (address.hasMore()) {
                boolean isInternational = address.octet("type of address") == AddressType.INTERNATIONAL;
                center = new Msisdn(SemiOctets.read(address), isInternational);
            }
            OctetString tpdu = in.rest();
            if (tpdu.length() != length || !RelayMessage.isTpduLength(length)) {
                throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
            }
            return new PduText(center, tpdu);
        } catch (ProtocolViolation | IllegalArgumentException broken) {
            throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
        }
    }

    /** The unit of a received or stored message. */
    public static Tpdu decode(OctetString tpdu) throws ProtocolViolation {
        boolean isSubmit = (tpdu.octet(0) & TYPE_MASK) == SUBMIT;
        return TpduCodec.decode(tpdu, isSubmit ? Direction.UPLINK : Direction.DOWNLINK);
    }

    /** The receiver of a SUBMIT. @throws AtException with 304 for another unit, or an address that is no number */
    public Msisdn receiver() throws AtException {
        try {
            if (TpduCodec.decode(tpdu, Direction.UPLINK) instanceof SubmitTpdu submit) {
                return submit.destination().number().orElseThrow(() -> new IllegalArgumentException("no number"));
            }
        } catch (ProtocolViolation | IllegalArgumentException broken) {
            throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
        }
        throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
    }

    /** The receiver of a COMMAND (TS 23.040, 9.2.2.4). @throws AtException with 304 for another unit */
    public Msisdn commandReceiver() throws AtException {
        try {
            MessageReader in = new MessageReader(tpdu);
            if ((in.octet("first octet") & TYPE_MASK) != COMMAND) {
                throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
            }
            in.string(COMMAND_ADDRESS - 1, "command");
            int digits = in.octet("address length");
            boolean isInternational = in.octet("type of address") == AddressType.INTERNATIONAL;
            return new Msisdn(SemiOctets.readCounted(in, digits), isInternational);
        } catch (ProtocolViolation | IllegalArgumentException broken) {
            throw AtException.ofMessage(CmsError.INVALID_PDU_PARAMETER);
        }
    }

    /** Octets of the unit alone. */
    public int length() {
        return tpdu.length();
    }

    /** In capitals, with the service centre. */
    public String digits() {
        OctetWriter address = new OctetWriter().octet(AddressType.of(serviceCenter.toString()));
        SemiOctets.write(address, serviceCenter.digits(), 0);
        OctetString center = address.toOctetString();
        OctetWriter all =
                new OctetWriter().octet(center.length()).string(center).string(tpdu);
        return all.toOctetString().toString().toUpperCase(Locale.ROOT);
    }
}
