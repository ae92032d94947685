package simgsm.station.mobility;

import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.random.RandomGenerator;
import simgsm.air.Imsi;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.MobilityManagement.TmsiReallocationCommand;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.octets.OctetString;
import simgsm.sim.PinLock;
import simgsm.state.StateMachine;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationAction;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationEvent;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationState;

/** Registers the station and keeps it registered; runs by {@link MobileRegistrationTable}. */
public final class MobileRegistration {
    /** Ciphering key sequence number that means "no key" (TS 24.008, 10.5.1.2). */
    private static final int NO_KEY = 7;

    /** First pause after a failure on a link to our own centre, without towers; it doubles up to 16 s. */
    private static final long QUICK_NANOS = 1_000_000_000L;

    private static final int MOST_DOUBLINGS = 4;
    /** Over towers: attempts with T3211 between them; then T3212 (TS 24.008, 4.4.4.9). */
    private static final int ATTEMPTS = 4;

    private final StationContext context;
    private final PinLock lock;
    private final StateMachine<MobileRegistrationState, MobileRegistrationEvent, MobileRegistrationAction> machine;
    private boolean cellFound;
    private int keySequence = NO_KEY;
    /** The ciphering key Kc of the latest challenge. */
    private Optional<OctetString> cipherKey = Optional.empty();

    private int failures;
    private boolean isSimInvalid;
    private Optional<Tmsi> tmsi = Optional.empty();
    private LocationArea area = LocationArea.TEST;
    /** Location area of the serving cell; empty until a cell has sent it. */
    private Optional<LocationArea> cellArea = Optional.empty();

    private final PeriodicUpdating periodic;
    private LocationUpdatingType updatingType = LocationUpdatingType.IMSI_ATTACH;
    private Optional<MobileIdentity> offeredIdentity = Optional.empty();
    private Optional<RejectCause> rejectCause = Optional.empty();
    private boolean cardRefused;
    /** Null before the first report. */
    private StationEvent lastReport;

    /**
     * Switched on, without a cell.
     *
     * @param lock the card's: without its PIN the station does not register
     * @param random spreads the first periodic updates of many mobiles
     */
    public MobileRegistration(StationContext context, PinLock lock, RandomGenerator random) {
        this.context = context;
        this.lock = lock;
        periodic = new PeriodicUpdating(context.timers(), random);
        machine = new StateMachine<>(
                MobileRegistrationTable.TABLE, context.identity().number(), this::perform);
        fire(MobileRegistrationEvent.POWER_ON);
    }

    /** Fires an event without data: power on, channel released. */
    public void fire(MobileRegistrationEvent event) {
        machine.fire(event);
    }

    private MobileRegistrationState state() {
        return machine.state();
    }

    public boolean isRegistered() {
        return state() == MobileRegistrationState.NORMAL_SERVICE;
    }

    /** True if the network has refused; a later attempt may succeed. */
    public boolean isRefused() {
        return state() == MobileRegistrationState.LIMITED_SERVICE
                || state() == MobileRegistrationState.ATTEMPTING_TO_UPDATE && rejectCause.isPresent();
    }

    /** True if the station is switched off and its detach has ended. */
    public boolean isOff() {
        return state() == MobileRegistrationState.NULL;
    }

    public boolean isPowered() {
        return !isOff() && state() != MobileRegistrationState.IMSI_DETACH_INITIATED;
    }

    /** True while registration itself uses the radio connection. */
    public boolean needsRadio() {
        return state() == MobileRegistrationState.LOCATION_UPDATING_INITIATED
                || state() == MobileRegistrationState.IMSI_DETACH_INITIATED;
    }

    public Optional<RejectCause> rejectCause() {
        return rejectCause;
    }

    /** True if the network has refused because the SIM failed authentication. */
    public boolean isCardRefused() {
        return cardRefused;
    }

    private void clearRefusal() {
        rejectCause = Optional.empty();
        cardRefused = false;
    }

    /** The identity for the air interface: the TMSI if there is one, else the IMSI. */
    public MobileIdentity identity() {
        return tmsi.<MobileIdentity>map(t -> t).orElse(context.identity().imsi());
    }

    /** The identity for a service: without registration the equipment's, for an emergency call (TS 24.008, 4.5.1.5). */
    MobileIdentity serviceIdentity() {
        return isRegistered() ? identity() : context.identity().imei();
    }

    /** True in a cell, without a location update under way. */
    boolean permitsEmergencyCall() {
        return cellFound && isPowered() && !needsRadio();
    }

    public boolean isOwn(MobileIdentity identity) {
        return identity.equals(context.identity().imsi())
                || tmsi.isPresent() && tmsi.get().equals(identity);
    }

    public int keySequence() {
        return keySequence;
    }

    /** The ciphering key Kc; empty before a challenge, and without a SIM. */
    public Optional<OctetString> cipherKey() {
        return cipherKey;
    }

    void setKey(int newKeySequence, OctetString newKey) {
        keySequence = newKeySequence;
        cipherKey = Optional.of(newKey);
    }

    public void cellFound() {
        if (!cellFound) {
            cellFound = true;
            failures = 0;
            searchCell();
        }
    }

    /**
     * The cell has sent its identity. A registration without an answer, as without a cell, is repeated in it at once
     * (TS 24.008, 4.2.2.2); a refused one keeps its pause.
     *
     * @param periodicUpdatingSteps T3212, of 6 minutes; 0 for none
     */
    public void camped(LocationArea newArea, int periodicUpdatingSteps) {
        boolean isNewArea = cellArea.isPresent() && !cellArea.get().equals(newArea);
        cellArea = Optional.of(newArea);
        periodic.told(periodicUpdatingSteps, isRegistered());
        if (state() == MobileRegistrationState.LIMITED_SERVICE && isNewArea && !isSimInvalid) {
            fire(MobileRegistrationEvent.NEW_AREA);
        }
        if (state() == MobileRegistrationState.ATTEMPTING_TO_UPDATE && rejectCause.isEmpty()) {
            failures = 0;
            fire(MobileRegistrationEvent.CELL_FOUND);
        }
    }

    /**
     * Updates the location if the cell belongs to another area or T3212 has expired (TS 24.008, 4.4.1 and 4.4.2).
     * Call it without a radio connection.
     */
    public void keepLocation() {
        if (!isRegistered()) {
            seekService(); // the card has been given its PIN
            return;
        }
        periodic.idle();
        if (cellArea.isPresent() && !cellArea.get().equals(area)) {
            update(LocationUpdatingType.NORMAL, MobileRegistrationEvent.NEW_AREA);
        } else if (periodic.isDue()) {
            update(LocationUpdatingType.PERIODIC, MobileRegistrationEvent.T3212_EXPIRED);
        }
    }

    /** The network has sent a layer 3 message above radio resources, so it knows the mobile's place. */
    public void contacted() {
        if (isRegistered()) {
            periodic.contacted();
        }
    }

    private void update(LocationUpdatingType type, MobileRegistrationEvent reason) {
        updatingType = type;
        fire(reason);
    }

    public void linkLost() {
        cellFound = false;
        cellArea = Optional.empty();
        if (!isSimInvalid) {
            clearRefusal();
        }
        fire(MobileRegistrationEvent.LINK_LOST);
    }

    public void powerOn() {
        if (!isPowered()) {
            lock.reset();
        }
        fire(MobileRegistrationEvent.POWER_ON);
    }

    public void powerOff() {
        isSimInvalid = false;
        clearRefusal();
        fire(MobileRegistrationEvent.POWER_OFF);
    }

    void accepted(LocationUpdatingAccept accept) {
        if (machine.accepts(MobileRegistrationEvent.LOCATION_UPDATING_ACCEPTED)) {
            area = accept.area();
            offeredIdentity = accept.newIdentity();
            clearRefusal();
            failures = 0;
        }
        fire(MobileRegistrationEvent.LOCATION_UPDATING_ACCEPTED);
    }

    void rejected(RejectCause cause) {
        if (state() == MobileRegistrationState.LOCATION_UPDATING_INITIATED) {
            rejectCause = Optional.of(cause);
            isSimInvalid = isOverTowers() && FinalCauses.invalidateSim(cause);
        }
        fire(
                FinalCauses.contain(cause, isOverTowers())
                        ? MobileRegistrationEvent.LOCATION_UPDATING_FORBIDDEN
                        : MobileRegistrationEvent.LOCATION_UPDATING_REJECTED);
    }

    /** TS 24.008, 4.3.2.5. */
    void authenticationRejected() {
        cardRefused = true;
        barred(RejectCause.ILLEGAL_MS);
    }

    /** TS 24.008, 4.3.5.2: cause 6 ends the registration; any other only the connections. */
    void aborted(RejectCause cause) {
        if (cause == RejectCause.ILLEGAL_ME) {
            barred(cause);
        }
    }

    private void barred(RejectCause cause) {
        rejectCause = Optional.of(cause);
        isSimInvalid = isOverTowers();
        fire(MobileRegistrationEvent.AUTHENTICATION_REJECTED);
    }

    /** TS 24.008, 4.3.1.2. */
    void reallocated(TmsiReallocationCommand command) {
        area = command.area();
        offeredIdentity = Optional.of(command.identity());
        if (!(command.identity() instanceof Tmsi)) {
            context.radio().send(new TmsiReallocationComplete());
        }
        takeNewIdentity();
    }

    private void perform(MobileRegistrationAction action) {
        switch (action) {
            case SEARCH_CELL -> searchCell();
            case SEND_LOCATION_UPDATING_REQUEST -> sendLocationUpdatingRequest();
            case TAKE_NEW_IDENTITY -> takeNewIdentity();
            case FORGET_IDENTITY -> forgetIdentity();
            case SEND_IMSI_DETACH -> sendImsiDetach();
            case RELEASE_CHANNEL -> context.radio().release();
            case PAUSE -> pause();
            case STOP_TIMERS -> context.timers().stop(StationTimer.T3210, StationTimer.T3211, StationTimer.T3220);
            case REPORT_REGISTERED -> reportRegistered();
            case REPORT_UNREGISTERED -> reportUnregistered();
        }
    }

    private void searchCell() {
        context.radio().release();
        seekService();
    }

    private void seekService() {
        if (state() == MobileRegistrationState.NO_CELL_AVAILABLE
                && cellFound
                && !isSimInvalid
                && lock.status().isReady()) {
            fire(MobileRegistrationEvent.CELL_FOUND);
        }
    }

    private void start(StationTimer timer, long nanos, MobileRegistrationEvent expired) {
        context.timers().start(timer, nanos, () -> fire(expired));
    }

    /** Sent as the first message of a radio connection, so an open one is released first. */
    private void sendLocationUpdatingRequest() {
        context.radio().release();
        context.radio().send(new LocationUpdatingRequest(updatingType, keySequence, area, identity()));
        start(StationTimer.T3210, StationTimer.T3210.nanos(), MobileRegistrationEvent.T3210_EXPIRED);
    }

    private void takeNewIdentity() {
        offeredIdentity.ifPresent(offered -> {
            if (offered instanceof Tmsi newTmsi) {
                tmsi = Optional.of(newTmsi);
                context.radio().send(new TmsiReallocationComplete());
            } else if (offered instanceof Imsi) {
                tmsi = Optional.empty();
            }
        });
    }

    private void forgetIdentity() {
        tmsi = Optional.empty();
        keySequence = NO_KEY;
        cipherKey = Optional.empty();
    }

    /** Sent on its own connection: the network no longer reads one that it is about to release. */
    private void sendImsiDetach() {
        context.radio().release();
        context.radio().send(new ImsiDetachIndication(identity()));
        start(StationTimer.T3220, StationTimer.T3220.nanos(), MobileRegistrationEvent.T3220_EXPIRED);
    }

    private void pause() {
        long nanos = QUICK_NANOS << Math.min(failures, MOST_DOUBLINGS);
        failures++;
        if (isOverTowers()) {
            nanos = failures < ATTEMPTS ? StationTimer.T3211.nanos() : periodic.nanos();
        }
        updateAfter(nanos);
    }

    /** An emergency call keeps its radio connection. */
    private void updateAfter(long nanos) {
        context.timers().start(StationTimer.T3211, nanos, () -> {
            if (context.radio().isOpen()) {
                updateAfter(QUICK_NANOS);
            } else {
                fire(MobileRegistrationEvent.T3211_EXPIRED);
            }
        });
    }

    /** True if a cell has sent its identity; the centre sends none on its direct links. */
    private boolean isOverTowers() {
        return cellArea.isPresent();
    }

    private void reportRegistered() {
        boolean isFirst = updatingType == LocationUpdatingType.IMSI_ATTACH;
        updatingType = LocationUpdatingType.IMSI_ATTACH;
        periodic.stop();
        if (!isFirst) {
            context.log().trace(Level.INFO, "location updated: area {0}", Integer.toString(area.areaCode()));
            return;
        }
        lastReport = new StationEvent.StationRegistered(context.identity().number());
        context.log().trace(Level.INFO, "registered");
        context.events().add(lastReport);
    }

    private void reportUnregistered() {
        updatingType = LocationUpdatingType.IMSI_ATTACH;
        periodic.stop();
        StationEvent report = new StationEvent.StationUnregistered(rejectCause);
        if (!report.equals(lastReport)) {
            lastReport = report;
            String why = rejectCause.map(cause -> ": " + cause.title()).orElse("");
            context.log().trace(Level.INFO, "unregistered{0}", why);
            context.events().add(report);
        }
    }
}
