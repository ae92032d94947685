package simgsm.station;

import static simgsm.station.MobileRegistrationAction.*;
import static simgsm.station.MobileRegistrationEvent.*;
import static simgsm.station.MobileRegistrationState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** How a mobile registers, stays registered and leaves (TS 24.008, 4.4.4, 4.3.4 and 4.2.2). */
final class MobileRegistrationTable {
    static final StateTable<MobileRegistrationState, MobileRegistrationEvent, MobileRegistrationAction> ROWS =
            new StateTable<MobileRegistrationState, MobileRegistrationEvent, MobileRegistrationAction>(
                            "mobile registration", MobileRegistrationState.NULL)
                    .on(
                            EnumSet.of(NULL, IMSI_DETACH_INITIATED),
                            POWER_ON,
                            NO_CELL_AVAILABLE,
                            STOP_TIMERS,
                            LOOK_FOR_CELL)
                    .on(
                            EnumSet.of(NO_CELL_AVAILABLE),
                            CELL_FOUND,
                            LOCATION_UPDATING_INITIATED,
                            SEND_LOCATION_UPDATING_REQUEST)
                    .on(
                            EnumSet.of(LOCATION_UPDATING_INITIATED),
                            LOCATION_UPDATING_ACCEPTED,
                            NORMAL_SERVICE,
                            STOP_TIMERS,
                            TAKE_NEW_IDENTITY,
                            TELL_REGISTERED)
                    .on(
                            EnumSet.of(LOCATION_UPDATING_INITIATED),
                            LOCATION_UPDATING_REJECTED,
                            ATTEMPTING_TO_UPDATE,
                            STOP_TIMERS,
                            FORGET_IDENTITY,
                            TELL_UNREGISTERED,
                            PAUSE)
                    .on(
                            EnumSet.of(LOCATION_UPDATING_INITIATED),
                            LOCATION_UPDATING_FORBIDDEN,
                            LIMITED_SERVICE,
                            STOP_TIMERS,
                            FORGET_IDENTITY,
                            TELL_UNREGISTERED)
                    .on(
                            EnumSet.of(LOCATION_UPDATING_INITIATED, NORMAL_SERVICE),
                            AUTHENTICATION_REJECTED,
                            LIMITED_SERVICE,
                            STOP_TIMERS,
                            FORGET_IDENTITY,
                            TELL_UNREGISTERED)
                    .on(
                            EnumSet.of(LOCATION_UPDATING_INITIATED),
                            T3210_EXPIRED,
                            ATTEMPTING_TO_UPDATE,
                            RELEASE_CHANNEL,
                            TELL_UNREGISTERED,
                            PAUSE)
                    .on(
                            EnumSet.of(LOCATION_UPDATING_INITIATED),
                            CHANNEL_RELEASED,
                            ATTEMPTING_TO_UPDATE,
                            STOP_TIMERS,
                            TELL_UNREGISTERED,
                            PAUSE)
                    .on(
                            EnumSet.of(ATTEMPTING_TO_UPDATE),
                            T3211_EXPIRED,
                            LOCATION_UPDATING_INITIATED,
                            SEND_LOCATION_UPDATING_REQUEST)
                    .on(
                            EnumSet.of(NORMAL_SERVICE),
                            FORGOTTEN_BY_NETWORK,
                            LOCATION_UPDATING_INITIATED,
                            FORGET_IDENTITY,
                            SEND_LOCATION_UPDATING_REQUEST)
                    .stay(EnumSet.of(ATTEMPTING_TO_UPDATE, LIMITED_SERVICE, NORMAL_SERVICE), CHANNEL_RELEASED)
                    // The answer to a request that was made twice: the network pages by the identity that it gave last.
                    .stay(EnumSet.of(NORMAL_SERVICE), LOCATION_UPDATING_ACCEPTED, TAKE_NEW_IDENTITY)
                    .on(
                            EnumSet.range(NO_CELL_AVAILABLE, NORMAL_SERVICE),
                            LINK_LOST,
                            NO_CELL_AVAILABLE,
                            STOP_TIMERS,
                            FORGET_IDENTITY,
                            TELL_UNREGISTERED)
                    .stay(EnumSet.of(NULL), LINK_LOST)
                    .on(
                            EnumSet.of(
                                    NO_CELL_AVAILABLE,
                                    LOCATION_UPDATING_INITIATED,
                                    ATTEMPTING_TO_UPDATE,
                                    LIMITED_SERVICE),
                            POWER_OFF,
                            NULL,
                            STOP_TIMERS,
                            RELEASE_CHANNEL,
                            FORGET_IDENTITY,
                            TELL_UNREGISTERED)
                    .on(
                            EnumSet.of(NORMAL_SERVICE),
                            POWER_OFF,
                            IMSI_DETACH_INITIATED,
                            SEND_IMSI_DETACH,
                            FORGET_IDENTITY,
                            TELL_UNREGISTERED)
                    .on(EnumSet.of(IMSI_DETACH_INITIATED), CHANNEL_RELEASED, NULL, STOP_TIMERS)
                    .on(EnumSet.of(IMSI_DETACH_INITIATED), T3220_EXPIRED, NULL, RELEASE_CHANNEL)
                    .on(EnumSet.of(IMSI_DETACH_INITIATED), LINK_LOST, NULL, STOP_TIMERS);

    private MobileRegistrationTable() {}
}
