package simgsm.center.msc;

import java.time.Duration;
import java.util.Optional;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.center.subscriber.Subscriber;
import simgsm.center.timer.Timer;
import simgsm.center.timer.Timers;

/**
 * One location update (TS 24.008, 4.4.4): who is it, on which equipment, may it come; then its temporary identity, the
 * network's name, and the channel's release.
 */
final class Registration {
    private enum State {
        AWAITING_IMSI,
        AWAITING_IMEI,
        AWAITING_TMSI_COMPLETE
    }

    /** T3270, identification, and T3250, TMSI reallocation: 12 s each (TS 24.008, table 11.2). */
    private static final long ANSWER_NANOS = Duration.ofSeconds(12).toNanos();

    private final Link link;
    private final Mobility mobility;
    private final Timers timers;
    private State state;
    private Timer guard;
    /** Who claims to come; not of the register before all has gone well, or whoever is rejected would become known. */
    private Imsi imsi;

    Registration(Link link, Mobility mobility, Timers timers) {
        this.link = link;
        this.mobility = mobility;
        this.timers = timers;
    }

    void start(MobileIdentity identity) {
        if (identity instanceof Imsi said) {
            identified(said);
        } else if (identity instanceof Tmsi tmsi) {
            Optional<Subscriber> known = mobility.register().ofTmsi(tmsi);
            if (known.isPresent()) {
                identified(known.get().imsi());
            } else {
                ask(MobileIdentity.Type.IMSI, State.AWAITING_IMSI);
            }
        } else {
            reject(RejectCause.INVALID_MANDATORY_INFORMATION);
        }
    }

    /** Takes an answer of the mobile. Returns false if none of this kind is awaited. */
    boolean receive(MobilityManagement message) {
        if (message instanceof MobilityManagement.IdentityResponse response) {
            return receiveIdentity(response.identity());
        }
        if (message instanceof MobilityManagement.TmsiReallocationComplete && state == State.AWAITING_TMSI_COMPLETE) {
            if (link.subscriber != null) {
                mobility.register().confirmTmsi(link.subscriber);
            }
            link.send(new MobilityManagement.MmInformation(mobility.networkName()));
            end();
            return true;
        }
        return false;
    }

    private boolean receiveIdentity(MobileIdentity identity) {
        if (state == State.AWAITING_IMSI && identity instanceof Imsi said) {
            identified(said);
            return true;
        }
        if (state == State.AWAITING_IMEI && identity instanceof Imei imei) {
            equipped(imei);
            return true;
        }
        return false;
    }

    private void identified(Imsi who) {
        if (who.openNumber().isEmpty()) {
            reject(RejectCause.IMSI_UNKNOWN_IN_HLR);
            return;
        }
        imsi = who;
        ask(MobileIdentity.Type.IMEI, State.AWAITING_IMEI);
    }

    private void equipped(Imei imei) {
        Optional<Subscriber> subscriber = mobility.register().admit(imsi);
        if (subscriber.isEmpty()) {
            reject(RejectCause.CONGESTION);
        } else if (!mobility.claim(subscriber.get(), imei, link)) {
            reject(RejectCause.ILLEGAL_MS);
        } else {
            accept(subscriber.get(), imei);
        }
    }

    private void accept(Subscriber subscriber, Imei imei) {
        await(State.AWAITING_TMSI_COMPLETE);
        link.send(new MobilityManagement.LocationUpdatingAccept(
                LocationArea.TEST, Optional.of(mobility.register().allocateTmsi(subscriber))));
        mobility.attached(subscriber, imei, link);
    }

    private void ask(MobileIdentity.Type type, State next) {
        await(next);
        link.send(new MobilityManagement.IdentityRequest(type));
    }

    private void await(State next) {
        timers.cancel(guard);
        state = next;
        guard = timers.start(ANSWER_NANOS, this::end);
    }

    private void reject(RejectCause cause) {
        link.send(new MobilityManagement.LocationUpdatingReject(cause));
        end();
    }

    /** The connection served the update alone; whatever waits for the mobile pages it afterwards. */
    private void end() {
        cancel();
        link.radio.release();
    }

    /** Forgets the update; the radio connection has gone, or a new update begins. */
    void cancel() {
        timers.cancel(guard);
        link.registration = null;
    }
}
