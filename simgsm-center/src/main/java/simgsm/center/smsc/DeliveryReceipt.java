package simgsm.center.smsc;

/** Told once when a delivery attempt has ended. */
public interface DeliveryReceipt {
    void ended(DeliveryOutcome outcome);
}
