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
    /** Digits before a subscriber's number in its international form; empty for a network without a country. */
    private final String countryCode;

    private HomeRegister(Map<Imsi, Subscription> subscriptions, Collection<Imei> barredEquipment) {
        this.subscriptions = subscriptions;
        countryCode = "";
        this.barredEquipment =
                barredEquipment.stream().map(HomeRegister::compared).collect(Collectors.toSet());
    }

    private HomeRegister(HomeRegister other, String countryCode) {
        subscriptions = other.subscriptions;
        barredEquipment = other.barredEquipment;
        this.countryCode = countryCode;
    }

    public static HomeRegister open(Collection<Imei> barredEquipment) {
        return new HomeRegister(null, barredEquipment);
    }

    public static HomeRegister closed(Collection<Subscription> listed, Collection<Imei> barredEquipment) {
        Map<Imsi, Subscription> byImsi = new LinkedHashMap<>();
        listed.forEach(each -> byImsi.put(each.card().imsi(), each));
        return new HomeRegister(byImsi, barredEquipment);
    }

    /** The same in a country. @param code 1 to 3 digits (ITU-T E.164, 6.2.1); empty for none */
    public HomeRegister inCountry(String code) {
        if (!code.matches("|[1-9][0-9]{0,2}")) {
            throw new IllegalArgumentException("\"" + code + "\" is not a country code of 1 to 3 digits");
        }
        return new HomeRegister(this, code);
    }

    /** The subscriber's number of a dialled one; the same number if it is of another country. */
    public Msisdn called(Msisdn dialled) {
        if (countryCode.isEmpty() || !dialled.international()) {
            return dialled.plain();
        }
        boolean isOwn =
                dialled.digits().startsWith(countryCode) && dialled.digits().length() > countryCode.length();
        return isOwn ? new Msisdn(dialled.digits().substring(countryCode.length())) : dialled;
    }

    /** A subscriber's number as others see it: international in a network with a country. */
    public Msisdn shown(Msisdn number) {
        boolean fits = countryCode.length() + number.digits().length() <= Msisdn.MAX_DIGITS;
        return countryCode.isEmpty() || !fits ? number : new Msisdn(countryCode + number.digits(), true);
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
