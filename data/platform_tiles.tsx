<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" tiledversion="1.10.2" name="platform_tiles" tilewidth="32" tileheight="32" tilecount="8" columns="4">
 <image source="platform_tiles.png" width="128" height="64"/>
 <tile id="4">
  <objectgroup draworder="index" id="2">
   <object id="1" x="2" y="6" width="28" height="26">
    <ellipse/>
   </object>
  </objectgroup>
 </tile>
</tileset>
