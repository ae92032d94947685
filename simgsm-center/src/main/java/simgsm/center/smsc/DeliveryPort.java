package simgsm.center.smsc;

import simgsm.air.Msisdn;
import simgsm.air.OctetString;

/** The way from the short message centre to receivers. */
public interface DeliveryPort {
    /** Whether an attempt makes sense now. */
    boolean isReachable(Msisdn receiver);

    /**
     * Begins one attempt; the centre never begins a second one to the same receiver before the first has ended.
     *
     * @param tpdu DELIVER or STATUS-REPORT
     */
    void deliver(Msisdn receiver, OctetString tpdu, DeliveryReceipt receipt);
}
