/** Stored data of a modem: its SIM's messages, files and phone book, and its clock. */
package simgsm.modem.at.state;
