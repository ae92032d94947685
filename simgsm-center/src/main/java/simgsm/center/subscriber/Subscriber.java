package simgsm.center.subscriber;

import java.util.Optional;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.MobileIdentity;
import simgsm.air.Msisdn;
import simgsm.air.Tmsi;

/** A subscriber with number and IMSI, and the equipment and TMSI of the latest registration. */
public final class Subscriber {
    private final Msisdn number;
    private final Imsi imsi;
    private final CallServices services = new CallServices();
    private Imei imei;
    private Tmsi tmsi;
    private Tmsi formerTmsi;
    private boolean attached;
    private boolean entered;

    Subscriber(Msisdn number, Imsi imsi) {
        this.number = number;
        this.imsi = imsi;
    }

    public Msisdn number() {
        return number;
    }

    public Imsi imsi() {
        return imsi;
    }

    public CallServices services() {
        return services;
    }

    /** The equipment that last registered with this SIM. */
    public Optional<Imei> imei() {
        return Optional.ofNullable(imei);
    }

    public Optional<Tmsi> tmsi() {
        return Optional.ofNullable(tmsi);
    }

    public boolean isAttached() {
        return attached;
    }

    /** True if it has registered once. */
    boolean hasEntered() {
        return entered;
    }

    /** Marks the subscriber as known; true the first time. */
    boolean enter() {
        boolean isFirst = !entered;
        entered = true;
        return isFirst;
    }

    /** True for the IMSI, and for a TMSI as in {@link #answersTo}. */
    public boolean isNamed(MobileIdentity identity) {
        return identity instanceof Tmsi named ? answersTo(named) : imsi.equals(identity);
    }

    /** True for the TMSI, and for the previous one until the new one is confirmed. */
    public boolean answersTo(Tmsi candidate) {
        return candidate.equals(tmsi) || candidate.equals(formerTmsi);
    }

    Optional<Tmsi> formerTmsi() {
        return Optional.ofNullable(formerTmsi);
    }

    void tmsi(Tmsi newTmsi) {
        formerTmsi = tmsi;
        tmsi = newTmsi;
    }

    void forgetFormerTmsi() {
        formerTmsi = null;
    }

    void attach(Imei equipment) {
        imei = equipment;
        attached = true;
    }

    void detach() {
        attached = false;
    }

    @Override
    public String toString() {
        return number.digits();
    }
}
