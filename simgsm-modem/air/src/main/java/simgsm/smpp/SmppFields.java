package simgsm.smpp;

import java.util.List;
import simgsm.octets.OctetString;

/**
 * The fields of a PDU, one call each in order. A reader ignores the given value and returns the one read; a writer
 * writes the given value and returns it. So one description of a PDU serves both directions.
 */
interface SmppFields {
    int octet(String field, int value) throws SmppViolation;

    /**
     * A value from 0 to {@code most}.
     *
     * @param status the answer to a larger one
     */
    int octet(String field, int value, int most, int status) throws SmppViolation;

    int fourOctets(String field, int value) throws SmppViolation;

    /**
     * A text terminated by a zero octet.
     *
     * @param most octets, including the zero
     * @param status the answer to a longer one
     */
    String text(String field, int most, int status, String value) throws SmppViolation;

    /** sm_length and short_message: at most {@link SmppMessage#MAX_SHORT_MESSAGE} octets. */
    OctetString shortMessage(OctetString value) throws SmppViolation;

    /** Optional parameters up to the end of the PDU. */
    List<Tlv> parameters(List<Tlv> values) throws SmppViolation;
}
