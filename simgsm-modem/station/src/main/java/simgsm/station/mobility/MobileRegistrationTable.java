package simgsm.station.mobility;

import static simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationAction.*;
import static simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationEvent.*;
import static simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** Registration of a mobile, its updates and its detach (TS 24.008, 4.4.4, 4.3.4 and 4.2.2). */
public final class MobileRegistrationTable {
    /** Mobility management states of a mobile needed for one cell (TS 24.008, 4.1.2.1). */
    public enum MobileRegistrationState {
        /** Switched off. */
        NULL,
        /** No link to a centre, or the centre has not identified itself. */
        NO_CELL_AVAILABLE,
        LOCATION_UPDATING_INITIATED,
        /** Refused or not answered; the next attempt follows after a pause. */
        ATTEMPTING_TO_UPDATE,
        /** Refused for good: the next attempt follows only after power on or in another cell. */
        LIMITED_SERVICE,
        /** Registered. */
        NORMAL_SERVICE,
        IMSI_DETACH_INITIATED
    }

    /** Events of {@link MobileRegistrationTable}. */
    public enum MobileRegistrationEvent {
        POWER_ON,
        POWER_OFF,
        CELL_FOUND,
        LINK_LOST,
        LOCATION_UPDATING_ACCEPTED,
        LOCATION_UPDATING_REJECTED,
        /** As before, with a cause that another attempt would meet again. */
        LOCATION_UPDATING_FORBIDDEN,
        AUTHENTICATION_REJECTED,
        /** A service was refused because the network has lost the registration. */
        FORGOTTEN_BY_NETWORK,
        /** The cell belongs to another location area. */
        NEW_AREA,
        CHANNEL_RELEASED,
        T3210_EXPIRED,
        T3211_EXPIRED,
        T3212_EXPIRED,
        T3220_EXPIRED
    }

    /** Actions of {@link MobileRegistration}. */
    public enum MobileRegistrationAction {
        SEARCH_CELL,
        SEND_LOCATION_UPDATING_REQUEST,
        TAKE_NEW_IDENTITY,
        FORGET_IDENTITY,
        SEND_IMSI_DETACH,
        RELEASE_CHANNEL,
        /** Waits before the next attempt, longer after each failure. */
        PAUSE,
        STOP_TIMERS,
        REPORT_REGISTERED,
        REPORT_UNREGISTERED
    }

    public static final StateTable<MobileRegistrationState, MobileRegistrationEvent, MobileRegistrationAction> TABLE =
            new StateTable<>("mobile registration", NULL);

    static {
        TABLE.on(NULL, POWER_ON, NO_CELL_AVAILABLE, STOP_TIMERS, SEARCH_CELL)
                .on(IMSI_DETACH_INITIATED, POWER_ON, NO_CELL_AVAILABLE, STOP_TIMERS, SEARCH_CELL)
                .on(NO_CELL_AVAILABLE, CELL_FOUND, LOCATION_UPDATING_INITIATED, SEND_LOCATION_UPDATING_REQUEST);
        updating();
        registered();
        leaving();
    }

    private MobileRegistrationTable() {}

    private static void updating() {
        var updating = LOCATION_UPDATING_INITIATED;
        var again = ATTEMPTING_TO_UPDATE;
        TABLE.on(
                        updating,
                        LOCATION_UPDATING_ACCEPTED,
                        NORMAL_SERVICE,
                        STOP_TIMERS,
                        TAKE_NEW_IDENTITY,
                        REPORT_REGISTERED)
                .on(
                        updating,
                        LOCATION_UPDATING_REJECTED,
                        again,
                        STOP_TIMERS,
                        FORGET_IDENTITY,
                        REPORT_UNREGISTERED,
                        PAUSE)
                .on(
                        updating,
                        LOCATION_UPDATING_FORBIDDEN,
                        LIMITED_SERVICE,
                        STOP_TIMERS,
                        FORGET_IDENTITY,
                        REPORT_UNREGISTERED)
                .on(
                        EnumSet.of(updating, NORMAL_SERVICE),
                        AUTHENTICATION_REJECTED,
                        LIMITED_SERVICE,
                        STOP_TIMERS,
                        FORGET_IDENTITY,
                        REPORT_UNREGISTERED)
                .on(updating, T3210_EXPIRED, again, RELEASE_CHANNEL, REPORT_UNREGISTERED, PAUSE)
                .on(updating, CHANNEL_RELEASED, again, STOP_TIMERS, REPORT_UNREGISTERED, PAUSE)
                .on(again, T3211_EXPIRED, updating, SEND_LOCATION_UPDATING_REQUEST)
                .on(again, CELL_FOUND, updating, STOP_TIMERS, SEND_LOCATION_UPDATING_REQUEST)
                .on(LIMITED_SERVICE, NEW_AREA, updating, SEND_LOCATION_UPDATING_REQUEST);
    }

    private static void registered() {
        TABLE.on(
                        NORMAL_SERVICE,
                        FORGOTTEN_BY_NETWORK,
                        LOCATION_UPDATING_INITIATED,
                        FORGET_IDENTITY,
                        SEND_LOCATION_UPDATING_REQUEST)
                .on(
                        EnumSet.of(NORMAL_SERVICE),
                        EnumSet.of(NEW_AREA, T3212_EXPIRED),
                        LOCATION_UPDATING_INITIATED,
                        SEND_LOCATION_UPDATING_REQUEST)
                .stay(EnumSet.of(ATTEMPTING_TO_UPDATE, LIMITED_SERVICE, NORMAL_SERVICE), CHANNEL_RELEASED)
                // The answer to a request sent twice: the network pages by the identity that it gave last.
                .stay(EnumSet.of(NORMAL_SERVICE), LOCATION_UPDATING_ACCEPTED, TAKE_NEW_IDENTITY);
    }

    private static void leaving() {
        var unregistered = EnumSet.range(NO_CELL_AVAILABLE, LIMITED_SERVICE);
        TABLE.on(
                        EnumSet.range(NO_CELL_AVAILABLE, NORMAL_SERVICE),
                        LINK_LOST,
                        NO_CELL_AVAILABLE,
                        STOP_TIMERS,
                        FORGET_IDENTITY,
                        REPORT_UNREGISTERED)
                .stay(EnumSet.of(NULL), LINK_LOST)
                .on(unregistered, POWER_OFF, NULL, STOP_TIMERS, RELEASE_CHANNEL, FORGET_IDENTITY, REPORT_UNREGISTERED)
                .on(
                        NORMAL_SERVICE,
                        POWER_OFF,
                        IMSI_DETACH_INITIATED,
                        SEND_IMSI_DETACH,
                        FORGET_IDENTITY,
                        REPORT_UNREGISTERED)
                .on(IMSI_DETACH_INITIATED, CHANNEL_RELEASED, NULL, STOP_TIMERS)
                .on(IMSI_DETACH_INITIATED, T3220_EXPIRED, NULL, RELEASE_CHANNEL)
                .on(IMSI_DETACH_INITIATED, LINK_LOST, NULL, STOP_TIMERS);
    }
}
