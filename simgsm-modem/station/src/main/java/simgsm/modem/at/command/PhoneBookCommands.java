package simgsm.modem.at.command;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.CmeError;
import simgsm.modem.at.state.CharacterSet;
import simgsm.modem.at.state.PhoneBooks;
import simgsm.sim.SimPhoneBook;

/** The phone book (TS 27.007, 8.11 to 8.14). */
final class PhoneBookCommands {
    private PhoneBookCommands() {}

    static void addTo(AtCommandTable<AtClient> table) {
        table.row("+CPBS")
                .read((client, request) -> {
                    String book = client.settings().phoneBook;
                    PhoneBooks books = client.modem().books();
                    request.answer(AtRequest.quoted(book), books.entries(book).size(), books.capacity(book));
                })
                .set(PhoneBookCommands::select);
        table.row("+CPBR")
                .testWith((client, request) -> request.answer(
                        "(1-" + client.modem().books().capacity(client.settings().phoneBook) + ")",
                        SimPhoneBook.MOST_DIGITS,
                        SimPhoneBook.MOST_LETTERS))
                .set(PhoneBookCommands::read);
        table.row("+CPBF")
                .testWith((client, request) -> request.answer(SimPhoneBook.MOST_DIGITS, SimPhoneBook.MOST_LETTERS))
                .set(PhoneBookCommands::find);
        table.row("+CPBW")
                .test("(1-" + SimPhoneBook.CAPACITY + ")," + SimPhoneBook.MOST_DIGITS + ",(129,145),"
                        + SimPhoneBook.MOST_LETTERS)
                .set(PhoneBookCommands::write);
    }

    private static void select(AtClient client, AtRequest request) throws AtException {
        String book = request.parameters().atMost(2).text(0).toUpperCase(Locale.ROOT);
        if (!client.modem().books().names().contains(book)) {
            throw new AtException(CmeError.INCORRECT_PARAMETERS);
        }
        client.settings().phoneBook = book;
    }

    private static void read(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(2);
        PhoneBooks books = client.modem().books();
        int capacity = books.capacity(client.settings().phoneBook);
        int first = place(parameters, 0, capacity);
        int last = parameters.given(1).isPresent() ? place(parameters, 1, capacity) : first;
        books.entries(client.settings().phoneBook).forEach((place, entry) -> {
            if (place >= first && place <= last) {
                answer(client, request, place, entry);
            }
        });
    }

    private static int place(AtParameters parameters, int index, int capacity) throws AtException {
        int place = parameters.number(index, 0, Integer.MAX_VALUE);
        if (place < 1 || place > capacity) {
            throw new AtException(CmeError.INVALID_INDEX);
        }
        return place;
    }

    private static void answer(AtClient client, AtRequest request, int place, SimPhoneBook.Entry entry) {
        CharacterSet set = client.settings().characterSet;
        request.answer(
                place,
                AtRequest.quoted(entry.number()),
                AddressType.of(entry.number()),
                AtRequest.quoted(set.encode(entry.name())));
    }

    private static void find(AtClient client, AtRequest request) throws AtException {
        String wanted = decoded(client, request.parameters().atMost(1).text(0));
        for (Map.Entry<Integer, SimPhoneBook.Entry> entry :
                client.modem().books().entries(client.settings().phoneBook).entrySet()) {
            if (entry.getValue().name().startsWith(wanted)) {
                answer(client, request, entry.getKey(), entry.getValue());
            }
        }
    }

    private static String decoded(AtClient client, String text) throws AtException {
        try {
            return client.settings().characterSet.decode(text);
        } catch (IllegalArgumentException notOfTheSet) {
            throw new AtException(CmeError.INVALID_TEXT);
        }
    }

    private static void write(AtClient client, AtRequest request) throws AtException {
        AtParameters parameters = request.parameters().atMost(4);
        PhoneBooks books = client.modem().books();
        if (!client.settings().phoneBook.equals(PhoneBooks.SIM)) {
            throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
        }
        Optional<String> given = parameters.given(0);
        int place = given.isPresent()
                ? place(parameters, 0, SimPhoneBook.CAPACITY)
                : books.sim().free().orElseThrow(() -> new AtException(CmeError.MEMORY_FULL));
        if (parameters.count() < 2) {
            if (given.isEmpty()) {
                throw new AtException(CmeError.INCORRECT_PARAMETERS);
            }
            books.sim().erase(place);
            return;
        }
        books.sim().write(place, entry(client, parameters));
    }

    private static SimPhoneBook.Entry entry(AtClient client, AtParameters parameters) throws AtException {
        String number = client.settings().characterSet.decodeNumber(parameters.text(1));
        boolean international = parameters.number(2, 128, 255, AddressType.of(number)) == AddressType.INTERNATIONAL;
        if (!number.matches("\\+?[0-9*#]*")) {
            throw new AtException(CmeError.INVALID_DIAL_STRING);
        }
        String name = decoded(client, parameters.text(3));
        if (number.length() > SimPhoneBook.MOST_DIGITS + 1 || name.length() > SimPhoneBook.MOST_LETTERS) {
            throw new AtException(CmeError.TEXT_TOO_LONG);
        }
        return new SimPhoneBook.Entry((international && !number.startsWith("+") ? "+" : "") + number, name);
    }
}
