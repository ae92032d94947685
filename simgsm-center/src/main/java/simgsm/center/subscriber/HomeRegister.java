package simgsm.center.subscriber;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;

/**
 * HLR with authentication centre, and EIR (TS 23.002, 4.1.1.1). A closed network has the listed subscribers only; in an open
 * one any SIM of the test network may register, and its IMSI contains its number. Immutable.
 */
public final class HomeRegister {
    /** An open network without barred equipment. */
    public static final HomeRegister OPEN = open(Set.of());

    /** Number of compared digits, without the last one: the check digit, or 0 as many phones send it. */
    private static final int COMPARED_IMEI_DIGITS = 14;

    /** Null in an open network. */
    private final Map<Imsi, Subscription> subscriptions;

    private final Set<String> barredEquipment;

    private HomeRegister(Map<Imsi, Subscription> subscriptions, Collection<Imei> barredEquipment) {
        this.subscriptions = subscriptions;
        this.barredEquipment =
                barredEquipment.stream().map(HomeRegister::compared).collect(Collectors.toSet());
    }

    public static HomeRegister open(Collection<Imei> barredEquipment) {
        return new HomeRegister(null, barredEquipment);
    }

    public static HomeRegister closed(Collection<Subscription> listed, Collection<Imei> barredEquipment) {
        Map<Imsi, Subscription> byImsi = new LinkedHashMap<>();
        listed.forEach(each -> byImsi.put(each.card().imsi(), each));
        return new HomeRegister(byImsi, barredEquipment);
    }

    public boolean isOpen() {
        return subscriptions == null;
    }

    /** The cards of a closed network, in the operator's order. */
    List<SimCard> cards() {
        List<SimCard> cards = new ArrayList<>();
        if (!isOpen()) {
            subscriptions.values().forEach(each -> cards.add(each.card()));
        }
        return cards;
    }

    /** The number of an identity; empty if the network has no such subscriber. */
    public Optional<Msisdn> numberOf(Imsi imsi) {
        return isOpen() ? imsi.openNumber() : cardOf(imsi).map(SimCard::number);
    }

    /** The card that authenticates an identity; empty in an open network. */
    public Optional<SimCard> cardOf(Imsi imsi) {
        return isOpen()
                ? Optional.empty()
                : Optional.ofNullable(subscriptions.get(imsi)).map(Subscription::card);
    }

    /** True if the operator has barred the subscriber. */
    public boolean isBarred(Imsi imsi) {
        return !isOpen()
                && subscriptions.containsKey(imsi)
                && subscriptions.get(imsi).isBarred();
    }

    /** True if the operator has barred the equipment. */
    public boolean isBarred(Imei imei) {
        return barredEquipment.contains(compared(imei));
    }

    private static String compared(Imei imei) {
        return imei.digits().substring(0, COMPARED_IMEI_DIGITS);
    }
}
