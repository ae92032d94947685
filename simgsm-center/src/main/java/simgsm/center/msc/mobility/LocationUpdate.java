package simgsm.center.msc.mobility;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.mobility.LocationUpdateTable.LocationUpdateAction;
import simgsm.center.msc.mobility.LocationUpdateTable.LocationUpdateEvent;
import simgsm.center.msc.mobility.LocationUpdateTable.LocationUpdateState;
import simgsm.center.subscriber.HomeRegister;
import simgsm.center.subscriber.Subscriber;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;

/** One location update: {@link LocationUpdateTable} driven by the mobile's messages. Nothing is ciphered. */
final class LocationUpdate {
    private static final System.Logger LOG = System.getLogger(LocationUpdate.class.getName());

    private final Link link;
    private final MobilityProcedures mobility;
    private final StateMachine<LocationUpdateState, LocationUpdateEvent, LocationUpdateAction> machine;
    private Timer guard;
    /** The claimed identity; it is registered only on admission. */
    private Imsi imsi;

    private boolean isIdentifiedByTmsi;
    private RejectCause rejectCause;
    private Subscriber admitted;
    private Imei equipment;

    LocationUpdate(Link link, MobilityProcedures mobility) {
        this.link = link;
        this.mobility = mobility;
        this.machine = new StateMachine<>(LocationUpdateTable.ROWS, link, this::perform).onEntry(before -> entered());
    }

    void start(MobileIdentity identity) {
        if (!link.rateLimits().admitRegistration()) {
            reject(RejectCause.CONGESTION);
        } else if (identity instanceof Imsi said) {
            identified(said);
        } else if (identity instanceof Tmsi tmsi) {
            Optional<Subscriber> known = mobility.register().ofTmsi(tmsi);
            isIdentifiedByTmsi = known.isPresent();
            known.ifPresentOrElse(
                    subscriber -> identified(subscriber.imsi()), () -> machine.fire(LocationUpdateEvent.TMSI_UNKNOWN));
        } else {
            reject(RejectCause.INVALID_MANDATORY_INFORMATION);
        }
    }

    /** Handles an answer of the mobile; false if it is not expected. */
    boolean receive(MobilityManagement message) {
        if (message instanceof MobilityManagement.IdentityResponse response) {
            return receiveIdentity(response.identity());
        }
        return message instanceof MobilityManagement.TmsiReallocationComplete
                && machine.fire(LocationUpdateEvent.TMSI_COMPLETE);
    }

    /** The answer to IDENTITY REQUEST cannot be decoded, such as an IMEI with a wrong check digit. */
    void identityInvalid() {
        if (isIn(LocationUpdateState.AWAITING_IMEI)) {
            reject(RejectCause.ILLEGAL_ME);
        } else if (isIn(LocationUpdateState.AWAITING_IMSI)) {
            reject(RejectCause.INVALID_MANDATORY_INFORMATION);
        }
    }

    private boolean isIn(LocationUpdateState state) {
        return machine.state() == state;
    }

    private boolean receiveIdentity(MobileIdentity identity) {
        if (isIn(LocationUpdateState.AWAITING_IMSI) && identity instanceof Imsi said) {
            if (said.equals(imsi)) {
                machine.fire(LocationUpdateEvent.CARD_REFUSED);
            } else {
                identified(said);
            }
            return true;
        }
        if (isIn(LocationUpdateState.AWAITING_IMEI) && identity instanceof Imei imei) {
            admit(imei);
            return true;
        }
        return false;
    }

    private void identified(Imsi said) {
        HomeRegister home = mobility.register().home();
        imsi = said;
        link.name(home.numberOf(said).map(Msisdn::digits).orElse("IMSI " + said.digits()));
        if (home.numberOf(said).isEmpty()) {
            reject(RejectCause.IMSI_UNKNOWN_IN_HLR);
        } else if (home.cardOf(said).isPresent()) {
            machine.fire(LocationUpdateEvent.IDENTIFIED_WITH_KEY);
        } else {
            identityHolds(LocationUpdateEvent.IDENTIFIED);
        }
    }

    /** A TMSI may have selected the wrong card; then the IMSI is requested (TS 24.008, 4.3.2.5). */
    private void authenticated(boolean hasKey) {
        if (hasKey) {
            identityHolds(LocationUpdateEvent.AUTHENTICATED);
        } else if (isIdentifiedByTmsi) {
            isIdentifiedByTmsi = false;
            machine.fire(LocationUpdateEvent.TMSI_WRONG);
        } else {
            machine.fire(LocationUpdateEvent.CARD_REFUSED);
        }
    }

    private void identityHolds(LocationUpdateEvent event) {
        if (mobility.register().home().isBarred(imsi)) {
            reject(RejectCause.PLMN_NOT_ALLOWED);
        } else {
            machine.fire(event);
        }
    }

    private void admit(Imei imei) {
        if (mobility.register().home().isBarred(imei)) {
            reject(RejectCause.ILLEGAL_ME);
            return;
        }
        Optional<Subscriber> subscriber = mobility.register().admit(imsi);
        if (subscriber.isEmpty()) {
            reject(RejectCause.CONGESTION);
        } else if (!mobility.claim(subscriber.get(), imei, link)) {
            // cause 3 would invalidate the SIM of a tower's mobile, although its former process may only have been
            // killed
            reject(link.access().isShared() ? RejectCause.CONGESTION : RejectCause.ILLEGAL_MS);
        } else {
            admitted = subscriber.get();
            equipment = imei;
            machine.fire(LocationUpdateEvent.ADMITTED);
        }
    }

    private void reject(RejectCause cause) {
        rejectCause = cause;
        machine.fire(LocationUpdateEvent.REFUSED);
    }

    /** Ends the update without a message: the radio connection is lost, or a new update begins. */
    void cancel() {
        machine.fire(LocationUpdateEvent.CANCELLED);
    }

    private void entered() {
        link.timers().cancel(guard);
        machine.state()
                .guard()
                .ifPresent(timer -> guard =
                        link.timers().start(timer.nanos(), () -> machine.fire(LocationUpdateEvent.TIMER_EXPIRED)));
        if (isIn(LocationUpdateState.ENDED)) {
            mobility.updateEnded(link);
        }
    }

    private void perform(LocationUpdateAction action) {
        switch (action) {
            case REQUEST_IMSI -> link.send(new MobilityManagement.IdentityRequest(MobileIdentity.Type.IMSI));
            case REQUEST_IMEI -> link.send(new MobilityManagement.IdentityRequest(MobileIdentity.Type.IMEI));
            case REQUEST_AUTHENTICATION ->
                mobility.authenticate(
                        link, mobility.register().home().cardOf(imsi).orElseThrow(), this::authenticated);
            case SEND_ACCEPT -> {
                link.send(new MobilityManagement.LocationUpdatingAccept(
                        link.access().area(), Optional.of(mobility.register().allocateTmsi(admitted))));
                mobility.attached(admitted, equipment, link);
            }
            case CONFIRM_TMSI -> mobility.register().confirmTmsi(admitted);
            case SEND_MM_INFORMATION -> link.send(mobility.information());
            case SEND_REJECT -> {
                log(rejectCause.title());
                link.send(new MobilityManagement.LocationUpdatingReject(rejectCause));
            }
            case SEND_AUTHENTICATION_REJECT -> {
                log("the card does not have its key");
                link.send(new MobilityManagement.AuthenticationReject());
            }
            case DETACH -> {
                link.loseTransactions();
                mobility.detach(link);
            }
            case RELEASE_CHANNEL -> link.radio().release();
        }
    }

    private void log(String reason) {
        LOG.log(Level.INFO, "{0}: registration refused, {1}{2}", link, reason, imsi == null ? "" : ", IMSI " + imsi);
    }
}
